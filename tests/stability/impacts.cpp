#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "tests/epsilon.h"
#include "tests/stability/all_cases.h"

/// Impacts from a millionth of the wave speed to three times it, and a projectile that goes through a plate.
namespace trajan::stability {

namespace {

using test::epsilon;
constexpr double length = 20, wave_speed = 10;  ///< of a bar, in cells; of its waves

/// A bar runs into an equal one at rest, at `part` of the wave speed.
Scene bars(const char* law, const char* scheme, double part) {
  Scene scene;
  scene.name = "bars";
  scene.domain = {Dimension::bar, {-20}, {2000}, 1, {}};
  scene.materials = {test::material(law, wave_speed * wave_speed, 0, 1)};
  const double gap = 0.01;
  scene.bodies = {{"first", "solid", Box{{0}, {length}}, 2, {number_text(part * wave_speed), {}}},
                  {"second", "solid", Box{{length + gap}, {2 * length + gap}}, 2, {}}};
  scene.contacts = {{}};
  // Until waves have run through both bars and back, and the bars are apart again.
  scene.analysis = {gap / (part * wave_speed) + 3 * length / wave_speed, 0};
  scene.numerics.scheme = scheme;
  scene.numerics.shape_functions = "quadratic_bspline";
  scene.outputs.samples = 200;
  scene.outputs.snapshots = 1;
  scene.outputs.probes = {{"second", Region{Box{{length}, {2 * length + gap}}}, {Field::velocity}, "second"}};
  return scene;
}

double momentum_lost(const Attempt& run) {
  const std::vector<double> momentum = run.history("momentum.x");
  double worst = 0;
  for (double value : momentum) worst = std::max(worst, std::abs(value / momentum[0] - 1));
  return worst;
}

void add_bars(std::vector<Extreme>& extremes) {
  for (const char* law : {"linear_elastic", "neo_hookean"})
    for (const char* scheme : {"MUSL", "USL"})
      for (double part : {1e-6, 1e-3, 0.1, 0.5, 1.0, 3.0}) {
        Extreme extreme;
        const std::string name =
            std::string("bars at ") + number_text(part) + " of the wave speed, " + law + ", " + scheme;
        extreme.scene = bars(law, scheme, part);
        // Fronts are steps, which ring, and USL smooths; what is more than this is doubtful by the solver's own
        // measure.
        extreme.name = name;
        extreme.claim = "balance of energy";
        extreme.bound = 0.15;
        extreme.may_stop = part > 0.1 || scheme == std::string("USL");
        extreme.figure = imbalance;
        extremes.push_back(extreme);
        // Each step rounds the momentum of every particle.
        extreme.claim = "momentum lost";
        extreme.bound = 1e4 * epsilon;
        extreme.figure = momentum_lost;
        extremes.push_back(extreme);
        if (part > 1e-3) continue;
        // d'Alembert: equal bars exchange their velocities. The nodes that meet lose a cell's share of it.
        extreme.claim = "error of the velocity that was given on";
        extreme.bound = 1 / length;
        extreme.figure = [part](const Attempt& run) {
          return run.last("second.velocity.x") / (part * wave_speed) - 1;
        };
        extremes.push_back(extreme);
      }
}

/// A hard square runs into a free plate that breaks, four times as high and half as thick.
Scene plate(const char* scheme, const char* shape, double part) {
  Scene scene;
  scene.name = "plate";
  scene.domain = {Dimension::plane_strain, {-10, -20}, {60, 24}, 0.5, 1};
  scene.materials = {test::material("neo_hookean", 1000, 0.3, 4), test::material("neo_hookean", 100, 0.3, 1)};
  scene.materials[1].name = "brittle";
  scene.materials[1].damage = {{"tensile_strength", 5}, {"shape", 2}};
  // Waves in the plate are as fast as sqrt(134.6).
  scene.bodies = {{"projectile", "solid", Box{{0, 0}, {4, 4}}, 2, {number_text(part * 11.6), {}}},
                  {"plate", "brittle", Box{{4.5, -6}, {6.5, 10}}, 2, {}}};
  scene.contacts = {{}};
  scene.analysis = {12 / (part * 11.6), 0};
  scene.numerics.scheme = scheme;
  scene.numerics.shape_functions = shape;
  scene.outputs.samples = 100;
  scene.outputs.snapshots = 1;
  return scene;
}

void add_plates(std::vector<Extreme>& extremes, Size size) {
  for (const char* scheme : {"MUSL", "USL"})
    for (const char* shape : {"linear", "quadratic_bspline"})
      for (double part : {0.1, 1.0, 3.0}) {
        if (size == Size::quick && (part == 0.1 || scheme == std::string("USL"))) continue;
        Extreme extreme;
        extreme.name = std::string("projectile through a plate at ") + number_text(part) + " of the wave speed, " +
                       scheme + " " + shape;
        extreme.scene = plate(scheme, shape, part);
        extreme.may_stop = true;
        extreme.claim = "balance of energy";
        extreme.bound = 0.15;
        extreme.figure = imbalance;
        extremes.push_back(extreme);
        extreme.claim = "momentum lost";
        extreme.bound = 1e4 * epsilon;
        extreme.figure = momentum_lost;
        extremes.push_back(extreme);
      }
}

}  // namespace

std::vector<Extreme> impacts(Size size) {
  std::vector<Extreme> extremes;
  add_bars(extremes);
  add_plates(extremes, size);
  return extremes;
}

}  // namespace trajan::stability
