#include <cmath>

#include "tests/epsilon.h"
#include "tests/stability/all_cases.h"

/// Bodies thinner than a cell, particles alone, few and many, light beside heavy, and places that rounding
/// decides.
namespace trajan::stability {

namespace {

using test::epsilon;

/// A body that flies through 9 cells in 30 samples.
Scene flying(const Region& geometry, int per_cell_side) {
  Scene scene;
  scene.name = "flying";
  scene.domain = {Dimension::plane_strain, {0, 0}, {16, 16}, 1, 1};
  scene.materials = {test::material("neo_hookean", 100, 0.3, 1)};
  scene.bodies = {{"body", "solid", geometry, per_cell_side, {"3", "2"}}};
  scene.analysis = {3, 0};
  scene.outputs.samples = 30;
  scene.outputs.snapshots = 1;
  scene.outputs.probes = {{"body", Vector{3, 3}, {Field::displacement, Field::stress}, ""}};
  return scene;
}

/// How far the body is from where it should be, in cells.
double astray(const Attempt& run) {
  return std::hypot(run.last("body.displacement.x") - 9, run.last("body.displacement.y") - 6);
}

void add_flights(std::vector<Extreme>& extremes) {
  const std::pair<const char*, Box> bodies[] = {
      {"a single particle", {{3, 3}, {3.5, 3.5}}},
      {"a body of a thousandth of a cell", {{3, 3}, {3.001, 3.001}}},
      {"a sheet of a thousandth of a cell", {{3, 3}, {6, 3.001}}},
      {"particles on faces of cells", {{2.75, 2.75}, {4.75, 4.75}}},
      {"particles 1 ulp before faces", {{std::nextafter(2.75, 0), 2.75}, {4.75, 4.75}}},
      {"particles 1 ulp behind faces", {{std::nextafter(2.75, 9), 2.75}, {4.75, 4.75}}},
  };
  for (const auto& [name, box] : bodies)
    for (int per_cell_side : {1, 2, 8})
      for (const char* scheme : {"MUSL", "USL", "TLMPM"}) {
        Extreme extreme;
        extreme.name = std::string(name) + ", " + std::to_string(per_cell_side) + " per cell side, " + scheme;
        extreme.claim = "distance from its path, in cells";
        extreme.scene = flying(box, per_cell_side);
        extreme.scene.numerics.scheme = scheme;
        // What a picture could not show. Rounding of some 100 steps is 1e-12, and is multiplied where a sheet of
        // one particle per cell leaves nodes next to no mass.
        extreme.bound = 1e-4;
        extreme.figure = astray;
        // A lattice whose spacing is that of half a cell has no place for a particle in what is smaller.
        extreme.refused_for = "bodies[0]";
        extremes.push_back(extreme);
      }
}

/// Something light runs into something heavy: it comes back, and momentum is kept.
void add_mass_ratios(std::vector<Extreme>& extremes) {
  for (double ratio : {1e-3, 1e-6, 1e-9}) {
    Extreme extreme;
    char name[64];
    std::snprintf(name, sizeof name, "%g of the other's density", ratio);
    extreme.name = name;
    extreme.claim = "change of momentum";
    extreme.scene = flying(Box{{3, 3}, {5, 5}}, 2);
    MaterialDefinition light = extreme.scene.materials[0];
    light.name = "light";
    light.density *= ratio;
    light.parameters["youngs_modulus"] *= ratio;
    extreme.scene.materials.push_back(light);
    extreme.scene.bodies[0].initial_velocity = {"0", "0"};
    extreme.scene.bodies.push_back({"light", "light", Box{{6, 3}, {8, 5}}, 2, {"-1", "0"}});
    // Each step rounds the momentum of the heavy one, which moves as fast as it was hit.
    extreme.bound = 1000 * 16 * epsilon;
    extreme.figure = [](const Attempt& run) {
      const std::vector<double> momentum = run.history("momentum.x");
      double worst = 0;
      for (double value : momentum) worst = std::max(worst, std::abs(value / momentum[0] - 1));
      return worst;
    };
    extremes.push_back(extreme);
  }
}

/// The first axial mode of a bar thinner than a cell, wherever it lies in it; nothing happens across it.
void add_thin_bars(std::vector<Extreme>& extremes) {
  for (const char* scheme : {"MUSL", "TLMPM"})
    for (double lower : {0.0, 0.3, 0.45})
      for (double height : {0.25, 0.01}) {
        Extreme extreme;
        char name[96];
        std::snprintf(name, sizeof name, "bar of %g cells, %g above a face, %s", 2 * height, 2 * lower, scheme);
        extreme.name = name;
        extreme.claim = "deviation of the tip, in amplitudes";
        extreme.scene = test::bar(scheme, "linear_elastic", 0.5, 0.1);
        extreme.scene.bodies[0].geometry = Box{{0, lower}, {10, lower + height}};
        extreme.scene.bodies[0].particles_per_cell_side = 4;
        extreme.scene.outputs.probes[0].where = Vector{10, lower};
        // Of second order: a period is off by (pi / 40)^2 / 24 of itself with 20 cells; wave speeds change with
        // the strain of 0.016.
        extreme.bound = 0.02;
        extreme.figure = [](const Attempt& run) {
          const double omega = 0.05 * M_PI * 10, amplitude = 0.1 / omega;
          const std::vector<double> tip = run.history("tip.displacement.x");
          double worst = 0;
          for (std::size_t i = 0; i < tip.size(); ++i)
            worst = std::max(worst, std::abs(tip[i] - amplitude * std::sin(omega * run.memory.times[i])));
          return worst / amplitude;
        };
        extremes.push_back(extreme);
      }
}

}  // namespace

std::vector<Extreme> tiny(Size) {
  std::vector<Extreme> extremes;
  add_flights(extremes);
  add_mass_ratios(extremes);
  add_thin_bars(extremes);
  return extremes;
}

}  // namespace trajan::stability
