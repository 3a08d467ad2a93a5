#include "tests/bench/measurement.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "solver/analyses/run.h"
#include "solver/model/validate.h"
#include "solver/simulation/simulation.h"

namespace trajan::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::int64_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{usage.ru_maxrss} * 1024;
}

/// The arrays whose bits a step has changed.
std::int64_t arrays_written(const Executor& executor, const std::vector<BodyParticles>& before) {
  std::int64_t written = 0;
  for (std::size_t a = 0; a < attribute_count; ++a)
    written += executor.bodies()[0].arrays[a] != before[0].arrays[a];
  return written;
}

/// A copy of what particles carry.
std::vector<BodyParticles> copy_of(const std::vector<BodyParticles>& bodies) {
  std::vector<BodyParticles> copies(1);
  copies[0].arrays = bodies[0].arrays;
  return copies;
}

/// What must go between memory and processor at least, if caches hold a tile and no more: in each sweep all that
/// particles carry is read; what a step changes is written once a sweep; nodes and windows are read and written
/// once between two sweeps.
double count_bytes(const ModelPlan& planned, std::int64_t written) {
  const auto sweeps = static_cast<double>(planned.sweeps.size());
  const auto particles = static_cast<double>(planned.particles);
  const double carried = static_cast<double>(planned.particle_bytes) / particles;
  return sweeps * (carried + 2 * static_cast<double>(planned.grid_bytes) / particles) +
         static_cast<double>(written) * sizeof(double);
}

/// Of the transfers of a step alone: mass, momentum and force to the nodes, momentum a second time, acceleration,
/// velocity and gradient back.
double count_multiply_adds(const Model& model) {
  const std::string& shape = model.numerics.shape_functions;
  const double d = grid_axes(model.dimension);
  const double along = shape == "linear" ? 2 : shape == "cubic_bspline" ? 4 : 3;
  const double affine = model.numerics.transfer == "APIC" ? 2 * d * d : 0;
  return std::pow(along, d) * (1 + 4 * d + 2 * d * d + affine);
}

/// When discs that spin by one radian per unit of time have turned far enough that no row of particles stays
/// within a row of cells.
constexpr double time_of_turned = 0.2;

void measure_steps(const Model& model, const Choice& choice, int threads, Clock::time_point begin,
                   Measurement& measured) {
  Simulation simulation(model, threads);
  simulation.step();
  measured.start = seconds_since(begin);
  simulation.step();
  measured.peak_bytes = peak_bytes();  // before anything is copied or planned
  const std::vector<BodyParticles> before = copy_of(simulation.executor().bodies());
  simulation.step();
  const ModelPlan planned = plan(model);
  measured.bytes_moved = count_bytes(planned, arrays_written(simulation.executor(), before));
  measured.multiply_adds = count_multiply_adds(model);

  while (choice.turned && simulation.time() < time_of_turned) simulation.step();

  // Long enough for the clock, and so few steps that coarse discs have not flown apart at the end.
  const auto steps = static_cast<int>(std::clamp(2e6 / static_cast<double>(measured.particles), 1.0, 100.0));
  constexpr int most_repetitions = 20, least_repetitions = 5;
  constexpr double longest = 2;  // seconds
  const Clock::time_point first = Clock::now();
  for (int r = 0; r < most_repetitions && (r < least_repetitions || seconds_since(first) < longest); ++r) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < steps; ++i) simulation.step();
    measured.nanoseconds.push_back(1e9 * seconds_since(start) / steps / static_cast<double>(measured.particles));
    measured.steps += steps;
  }
  measured.solver_bytes = static_cast<std::int64_t>(simulation.executor().memory());
}

void measure_run(const Model& model, int threads, Measurement& measured) {
  Simulation simulation(model, threads);
  const Clock::time_point start = Clock::now();
  while (simulation.sample() < model.outputs.samples) simulation.step();
  const double seconds = seconds_since(start);
  measured.steps = plan(model).steps;
  measured.nanoseconds = {1e9 * seconds / static_cast<double>(measured.steps * measured.particles)};
  measured.solver_bytes = static_cast<std::int64_t>(simulation.executor().memory());
  measured.peak_bytes = peak_bytes();
}

}  // namespace

Measurement measure(const Case& of, double particles, int threads) {
  Measurement measured;
  const Clock::time_point begin = Clock::now();
  const Model model = validate(of.make(of.choice, particles));
  measured.validation = seconds_since(begin);
  measured.particles = model.particle_count();
  if (of.choice.kind == Kind::explicit_steps)
    measure_steps(model, of.choice, threads, begin, measured);
  else
    measure_run(model, threads, measured);
  return measured;
}

}  // namespace trajan::bench
