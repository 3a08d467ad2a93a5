#include <benchmark/benchmark.h>

#include "solver/model/validate.h"
#include "solver/simulation/simulation.h"

namespace {

using namespace trajan;

/// The colliding discs of Sulsky, Chen and Schreyer (1994), with room to fly apart however many iterations
/// are asked for.
Model discs(const std::string& scheme, const std::string& law, double cell) {
  Scene scene;
  scene.name = "discs";
  scene.domain = {Dimension::plane_strain, {-100, -100}, {101, 101}, cell, 1};
  scene.materials = {{"solid", 1000, law, {{"youngs_modulus", 1000}, {"poissons_ratio", 0.3}}}};
  scene.bodies = {{"one", "solid", Disc{{0.2, 0.2}, 0.2}, 2, {"0.1", "0.1"}},
                  {"two", "solid", Disc{{0.8, 0.8}, 0.2}, 2, {"-0.1", "-0.1"}}};
  scene.analysis.end_time = 3;
  scene.numerics.scheme = scheme;
  scene.outputs.samples = 3;
  scene.outputs.snapshots = 1;
  return validate(scene);
}

/// One iteration is 20 steps on one core. Reports nanoseconds per particle and step, and the bytes that the
/// solver holds per particle.
void steps(benchmark::State& state, const std::string& scheme, const std::string& law) {
  constexpr int steps = 20;
  const Model model = discs(scheme, law, 1.0 / static_cast<double>(state.range(0)));
  Simulation simulation(model, 1);
  for (auto _ : state)
    for (int i = 0; i < steps; ++i) simulation.step();
  const auto particles = static_cast<double>(model.particle_count());
  state.counters["particles"] = particles;
  state.counters["ns/particle-step"] = benchmark::Counter(
      particles * steps * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["bytes/particle"] = static_cast<double>(simulation.executor().memory()) / particles;
}

BENCHMARK_CAPTURE(steps, MUSL_linear_elastic, "MUSL", "linear_elastic")->Arg(100)->Arg(320);
BENCHMARK_CAPTURE(steps, USL_linear_elastic, "USL", "linear_elastic")->Arg(320);
BENCHMARK_CAPTURE(steps, TLMPM_linear_elastic, "TLMPM", "linear_elastic")->Arg(320);
BENCHMARK_CAPTURE(steps, MUSL_neo_hookean, "MUSL", "neo_hookean")->Arg(320);

}  // namespace
