#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/stability/all_cases.h"

/// Waves from one elastic bar into another one that is much stiffer or denser.
namespace trajan::stability {

namespace {

constexpr double speed = 10, pulse = 0.001;

/// A pulse that runs to the right through the first of two joined bars. Waves are as fast in both of them.
Scene joined_bars(const char* scheme, double first, double second) {
  Scene scene;
  scene.name = "joined_bars";
  scene.domain = {Dimension::bar, {-10}, {210}, 0.5, {}};
  scene.materials = {test::material("linear_elastic", first * speed * speed, 0, first),
                     test::material("linear_elastic", second * speed * speed, 0, second)};
  scene.materials[1].name = "other";
  scene.bodies = {{"first", "solid", Box{{0}, {100}}, 2, {}}, {"second", "other", Box{{100}, {200}}, 2, {}}};
  // A wave that runs to the right has stress -density * speed * velocity.
  char text[96];
  std::snprintf(text, sizeof text, "%g*exp(-((x-50)/5)^2)", pulse);
  scene.bodies[0].initial_velocity.x = text;
  std::snprintf(text, sizeof text, "%g*exp(-((x-50)/5)^2)", -pulse * first * speed);
  scene.bodies[0].initial_stress.components[0] = text;
  scene.analysis = {9, 0};
  scene.numerics.scheme = scheme;
  scene.outputs.samples = 360;
  scene.outputs.snapshots = 1;
  scene.outputs.probes = {{"before", Vector{80}, {Field::velocity}, "first"},
                          {"behind", Vector{110}, {Field::velocity}, "second"}};
  return scene;
}

/// The velocity of largest magnitude from t = 5 on, when the pulse has passed the first probe and not yet come
/// back.
double peak(const Attempt& run, const char* column) {
  const std::vector<double> velocity = run.history(column);
  double peak = 0;
  for (std::size_t i = 0; i < velocity.size(); ++i)
    if (run.memory.times[i] > 5 && std::abs(velocity[i]) > std::abs(peak)) peak = velocity[i];
  return peak;
}

}  // namespace

std::vector<Extreme> contrasts(Size) {
  std::vector<Extreme> extremes;
  for (const char* scheme : {"MUSL", "USL", "TLMPM"})
    for (double ratio : {1e3, 1e6, 1e9, 1e-3, 1e-6, 1e-9}) {
      Extreme extreme;
      char name[96];
      std::snprintf(name, sizeof name, "%s, the second bar %g times as stiff and dense, ", scheme, ratio);
      extreme.scene = joined_bars(scheme, 1, ratio);
      // Ten cells in the pulse's half-width: dispersion takes a hundredth from its peak on the way (linear
      // functions, fourth derivative of the shape, c t h^2 / 24).
      extreme.bound = 0.02;
      extreme.name = name + std::string("what comes back");
      extreme.claim = "error of the velocity, relative";
      extreme.figure = [ratio](const Attempt& run) {
        return peak(run, "before.velocity.x") / (pulse * (1 - ratio) / (1 + ratio)) - 1;
      };
      extremes.push_back(extreme);
      extreme.name = name + std::string("what goes on");
      extreme.figure = [ratio](const Attempt& run) {
        return peak(run, "behind.velocity.x") / (pulse * 2 / (1 + ratio)) - 1;
      };
      extremes.push_back(extreme);
    }
  return extremes;
}

}  // namespace trajan::stability
