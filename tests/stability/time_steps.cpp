#include "solver/model/names.h"
#include "solver/schemes/scheme.h"
#include "solver/schemes/time_step.h"
#include "tests/stability/all_cases.h"

/// Time steps about the limit, with particles at the worst places in their cells. What is too long must end as
/// Diverged; up to the limit nothing may grow. Leapfrog with a step at the limit of the highest frequency swaps
/// energies by as much as there is in that mode, but an unstable mode multiplies them in every step.
namespace trajan::stability {

namespace {

struct Place {
  const char* name;
  int per_cell_side;
  double offset;  ///< of the block from the faces of cells, over the cell size
  bool at_faces;  ///< particles vibrate across faces of cells, or give nodes next to no mass
};
constexpr Place places[] = {{"regular", 2, 0, false},      {"on faces", 2, 0.25, true},
                            {"sliver", 2, 0.251, true},    {"thin sliver", 2, 0.25 + 1e-9, true},
                            {"one per cell", 1, 0, false}, {"one per cell, on nodes", 1, 0.5, true}};

/// A free elastic block of 3 cells a side, most of whose motion is in the shortest waves.
Scene shaken_block(Dimension dimension, const Place& place) {
  Scene scene;
  scene.name = "shaken_block";
  const int axes = grid_axes(dimension);
  const auto along = [axes](double value) { return Vector{value, axes > 1 ? value : 0, axes > 2 ? value : 0}; };
  scene.domain = {dimension, {}, along(12), 1, {}};
  scene.materials = {test::material("linear_elastic", 100, 0.3, 1)};
  const double lower = 4 + place.offset;
  scene.bodies = {{"block", "solid", Box{along(lower), along(lower + 3)}, place.per_cell_side, {}}};
  const std::string yz = axes > 2 ? "+31*y+71*z" : axes > 1 ? "+31*y" : "";
  scene.bodies[0].initial_velocity.x = "0.001*sin(41*x" + yz + ")";
  if (axes > 1) scene.bodies[0].initial_velocity.y = "0.001*sin(83*x" + yz + ")";
  if (axes > 2) scene.bodies[0].initial_velocity.z = "0.001*sin(67*x" + yz + ")";
  scene.outputs.samples = 10;
  scene.outputs.snapshots = 1;
  return scene;
}

Extreme at_step(Dimension dimension, const char* space, std::string_view scheme, std::string_view shape,
                const Place& place, double fraction) {
  Extreme extreme;
  extreme.name = std::string(space) + " " + std::string(scheme) + " " + std::string(shape) + ", " + place.name +
                 ", step " + number_text(fraction);
  extreme.claim = "growth of energy";
  // What an instability multiplies; the solver stops there by itself.
  extreme.bound = 0.5;
  extreme.scene = shaken_block(dimension, place);
  extreme.scene.numerics.scheme = scheme;
  extreme.scene.numerics.shape_functions = shape;
  extreme.scene.analysis.end_time = 1;
  extreme.figure = energy_gain;
  // Gradients of linear functions jump at faces (Bardenhagen and Kober 2004), and where stress follows from the
  // velocities of nodes with next to no mass, these run away (dissertation, section 3.2.2): energy comes from
  // nowhere with any step.
  const bool crosses = shape == "linear" && place.at_faces;
  extreme.may_stop = fraction > 1 || crosses || scheme == "USL";
  extreme.may_warn = true;            // of what leapfrog swaps
  extreme.refused_for = "numerics.";  // not every shape function goes with every scheme
  extreme.change = [fraction](Model& model) {
    model.numerics.time_step = fraction * time_step_limit(model).value;
    model.end_time = 300 * *model.numerics.time_step;
  };
  return extreme;
}

}  // namespace

std::vector<Extreme> time_steps(Size size) {
  std::vector<Extreme> extremes;
  const std::pair<Dimension, const char*> spaces[] = {
      {Dimension::bar, "bar"}, {Dimension::plane_strain, "plane"}, {Dimension::solid, "solid"}};
  for (const auto& [dimension, space] : spaces) {
    if (size == Size::quick && dimension == Dimension::solid) continue;
    for (std::string_view scheme : scheme_names())
      for (std::string_view shape : shape_names())
        for (const Place& place : places)
          for (double fraction : {0.5, 0.9, 0.99, 1.01, 2.0}) {
            if (size == Size::quick && fraction != 0.99 && fraction != 2) continue;
            extremes.push_back(at_step(dimension, space, scheme, shape, place, fraction));
          }
  }
  return extremes;
}

}  // namespace trajan::stability
