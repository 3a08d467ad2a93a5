// Explicit steps of every kind, in nanoseconds per particle and step.
#include <benchmark/benchmark.h>

#include "solver/simulation/simulation.h"
#include "tests/bench/scenes.h"

namespace trajan::bench {
namespace {

using MakeModel = Model (*)(const Choice&, double particles);

/// One iteration is so many steps. Reports nanoseconds per particle and step, and the bytes that the solver holds
/// per particle.
void steps(benchmark::State& state, const Choice& choice, MakeModel make) {
  constexpr int steps = 10;
  const Model model = make(choice, static_cast<double>(state.range(0)));
  Simulation simulation(model, static_cast<int>(state.range(1)));
  for (auto _ : state)
    for (int i = 0; i < steps; ++i) simulation.step();
  const auto particles = static_cast<double>(model.particle_count());
  state.counters["particles"] = particles;
  state.counters["ns/particle-step"] = benchmark::Counter(
      particles * steps * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["bytes/particle"] = static_cast<double>(simulation.executor().memory()) / particles;
}

struct Case {
  Choice choice;
  MakeModel make;
  std::vector<std::int64_t> particles = {100'000};
  std::vector<std::int64_t> threads = {1};
};

std::vector<Case> cases() {
  constexpr Dimension solid = Dimension::solid, axisymmetric = Dimension::axisymmetric;
  return {
      {{.name = "discs/MUSL"}, discs, {1000, 10'000, 100'000, 1'000'000}, {1, 2}},
      {{.name = "discs/USL", .scheme = "USL"}, discs},
      {{.name = "discs/TLMPM", .scheme = "TLMPM"}, discs},
      {{.name = "discs/TLMPM/neo_hookean", .scheme = "TLMPM", .law = "neo_hookean"}, discs},
      {{.name = "discs/MUSL/neo_hookean", .law = "neo_hookean"}, discs},
      {{.name = "discs/MUSL/contact", .contact = true}, discs},
      {{.name = "discs/MUSL/gimp", .shape_functions = "gimp"}, discs},
      {{.name = "discs/MUSL/quadratic_bspline", .shape_functions = "quadratic_bspline"}, discs},
      {{.name = "discs/TLMPM/quadratic_bspline", .scheme = "TLMPM", .shape_functions = "quadratic_bspline"},
       discs},
      {{.name = "discs/MUSL/quadratic_bspline/APIC", .shape_functions = "quadratic_bspline", .transfer = "APIC"},
       discs},
      {{.name = "discs/MUSL/cubic_bspline", .shape_functions = "cubic_bspline"}, discs},
      {{.name = "block/MUSL", .dimension = solid}, block, {100'000}, {1, 2}},
      {{.name = "block/TLMPM/neo_hookean", .scheme = "TLMPM", .law = "neo_hookean", .dimension = solid}, block},
      {{.name = "block/MUSL/quadratic_bspline", .shape_functions = "quadratic_bspline", .dimension = solid},
       block},
      {{.name = "block/MUSL/cubic_bspline", .shape_functions = "cubic_bspline", .dimension = solid}, block},
      {{.name = "column/TLMPM/damage", .scheme = "TLMPM", .damage = true, .dimension = axisymmetric}, block},
      {{.name = "column/MUSL/damage", .damage = true, .dimension = axisymmetric}, block},
  };
}

const bool registered = [] {
  for (const Case& c : cases())
    benchmark::RegisterBenchmark(c.choice.name.c_str(), steps, c.choice, c.make)
        ->ArgsProduct({c.particles, c.threads})
        ->ArgNames({"particles", "threads"})
        ->Iterations(20)  // coarse discs that fly on for thousands of steps fall apart
        ->UseRealTime();
  return true;
}();

}  // namespace
}  // namespace trajan::bench
