#include "solver/cost/course.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "solver/simulation/diverged.h"
#include "solver/simulation/simulation.h"

namespace trajan {

std::optional<Course> run_course(const Model& model, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  const auto processor_seconds = [begin = std::clock()] {
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  Course course{{}};
  try {
    Simulation simulation(model, 1);
    while (simulation.sample() < model.outputs.samples) {
      if (Clock::now() > end) return std::nullopt;
      simulation.step();
      course.push_back(
          {simulation.time() / model.end_time, static_cast<double>(simulation.steps()), processor_seconds()});
    }
  } catch (const Diverged&) {
    return std::nullopt;
  }
  return course;
}

Moment spent(const Course& course, double share) {
  const auto after = std::ranges::find_if(course, [&](const Moment& moment) { return moment.share >= share; });
  const Moment& whole = course.back();
  if (after == course.end()) return {1, 1, 1};
  Moment here = *after;
  if (after != course.begin()) {
    const Moment& before = *std::prev(after);
    const double between = (share - before.share) / (after->share - before.share);
    here.steps = std::lerp(before.steps, after->steps, between);
    here.seconds = std::lerp(before.seconds, after->seconds, between);
  }
  return {share, here.steps / whole.steps, whole.seconds > 0 ? here.seconds / whole.seconds : share};
}

}  // namespace trajan
