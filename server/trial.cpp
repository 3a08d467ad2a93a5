#include "server/trial.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "proto/field_change.h"
#include "server/convert.h"
#include "server/recorded_run.h"
#include "server/study_dials.h"
#include "solver/cost/course.h"
#include "solver/model/validate.h"

namespace trajan {

namespace {

/// A moment of the scene's own run.
struct Mark {
  double share = 0, wall_seconds = 0, core_seconds = 0, steps = 0, total_steps = 0;
};

/// A run that did not reach its end.
struct Beginning {
  std::vector<Mark> marks;  ///< at least one; each at another share
  Mark end;                 ///< of the last step, perhaps within a load step that has begun
  v1::Cost cost;            ///< with what comes before the first mark and after the end
};

/// What had been spent at a mark, as shares of the whole; without a course as if all steps were alike.
Moment spent_at(const Mark& mark, const std::optional<Course>& course, bool relaxes) {
  if (course) return spent(*course, mark.share);
  // A relaxation's present level tells nothing of the next.
  const double of_steps = mark.steps / std::max(mark.total_steps, 1.0);
  const double done = relaxes && mark.share > 0 ? std::min(of_steps, mark.share) : of_steps;
  return {mark.share, done, done};
}

/// What lies behind the last mark costs as much as what lies between it and the first, in proportion.
void extrapolate(const Beginning& begun, const std::optional<Course>& course, bool relaxes, v1::Trial& trial) {
  const Mark& last = begun.marks.back();
  const Moment at_last = spent_at(last, course, relaxes);
  Mark first = begun.marks.front();
  Moment at_first = spent_at(first, course, relaxes);
  // Within the first load step a mark does not show how far it is.
  if (first.share == 0 || !(at_first.seconds < at_last.seconds)) {
    first = {};
    at_first = {};
  }
  const double rest = (1 - at_last.seconds) / (at_last.seconds - at_first.seconds);
  const auto whole = [&](double Mark::*spent, double in_all) {
    return in_all - begun.end.*spent + last.*spent + rest * (last.*spent - first.*spent);
  };
  trial.mutable_cost()->set_wall_seconds(whole(&Mark::wall_seconds, begun.cost.wall_seconds()));
  trial.mutable_cost()->set_core_seconds(whole(&Mark::core_seconds, begun.cost.core_seconds()));
  trial.set_steps(last.steps / at_last.steps);
}

/// The same motion with cells so many times as large. Samples of explicit runs become as many times fewer: as many
/// steps lie between two of them, which are whole numbers.
std::optional<Course> course_of(v1::Scene scene, const Model& model, int factor, double seconds) {
  const v1::Setting cells = with_cell_size(scene, factor * scene.domain().cell_size());
  for (const std::string& change : cells.changes()) change_field(scene, change);
  if (std::holds_alternative<ExplicitDynamics>(model.analysis))
    scene.mutable_outputs()->set_samples(std::max(1, static_cast<int>(model.outputs.samples) / factor));
  scene.mutable_outputs()->set_snapshots(0);
  scene.mutable_outputs()->clear_probes();
  scene.clear_measures();
  try {
    return run_course(validate(to_scene(scene)), seconds);
  } catch (const InvalidScene&) {
    return std::nullopt;
  }
}

/// The course of the finest of the grids that suffice `seconds`; `expected`: what the scene itself takes.
std::optional<Course> coarse_course(const v1::Scene& scene, const Model& model, double expected, double seconds,
                                    std::string& basis) {
  for (const int factor : {2, 3, 4, 6, 8}) {
    if (expected / std::pow(factor, grid_axes(model.dimension) + 1) > 0.7 * seconds) continue;
    const auto course = course_of(scene, model, factor, seconds);
    if (!course || course->size() < 2) continue;
    basis += ", and with cells " + std::to_string(factor) + " times as large to its end";
    return course;
  }
  return std::nullopt;
}

}  // namespace

v1::Trial try_scene(const v1::Scene& message, const std::filesystem::path& directory, double seconds,
                    int threads) {
  const Scene scene = to_scene(message);
  Beginning begun;
  const RecordedRun run =
      record_run(scene, directory, threads, [&](const RunProgress& progress, const RunCost& cost) {
        const v1::Cost spent = cost.so_far();
        begun.end = {progress.time / progress.end_time, spent.wall_seconds(), spent.core_seconds(),
                     static_cast<double>(progress.step), static_cast<double>(progress.total_steps)};
        // Iterations within a load step do not show how far it is.
        if (begun.marks.empty() || begun.end.share > begun.marks.back().share) begun.marks.push_back(begun.end);
        return spent.wall_seconds() > 0.5 * seconds;
      });
  v1::Trial trial;
  trial.set_whole(run.result.end == RunEnd::finished);
  trial.set_basis("a whole run");
  trial.set_steps(static_cast<double>(run.result.progress.step));
  *trial.mutable_cost() = begun.cost = run.cost;
  if (run.result.divergence) trial.set_failure(run.result.divergence->cause);
  if (trial.whole() || run.result.divergence) return trial;
  const Model model = validate(scene);
  const bool relaxes = std::holds_alternative<Relaxation>(model.analysis);
  extrapolate(begun, std::nullopt, relaxes, trial);
  char share[32];
  std::snprintf(share, sizeof share, "%.2g %% of the run", 100 * begun.marks.back().share);
  std::string basis = share;
  const auto course =
      coarse_course(message, model, trial.cost().core_seconds(), seconds - run.cost.wall_seconds(), basis);
  if (course && spent(*course, begun.marks.back().share).seconds > 0) extrapolate(begun, course, relaxes, trial);
  trial.set_basis(basis);
  return trial;
}

}  // namespace trajan
