#include <cmath>
#include <cstdio>

#include "solver/model/names.h"
#include "tests/stability/all_cases.h"

/// Equilibria that are lost, are not one place, or hang by a thread.
namespace trajan::stability {

namespace {

/// A block from the origin to (length, 1), held along x at x = 0 and along y at its bottom, in one load step or
/// more.
Scene block(Dimension dimension, const char* law, double length, int load_steps) {
  Scene scene;
  scene.name = "block";
  const bool bar = dimension == Dimension::bar;
  scene.domain = {dimension, {-1, bar ? 0.0 : -2}, {length + 3, bar ? 0.0 : 4}, 0.25, {}};
  scene.materials = {test::material(law, 100, bar ? 0 : 0.3, 1)};
  scene.bodies = {{"block", "solid", Box{{0, 0}, {length, bar ? 0.0 : 1}}, 2, {}}};
  scene.boundaries = {{"left", Box{{-1, bar ? 0.0 : -2}, {0, bar ? 0.0 : 4}}, Fixed{{Axis::x}}}};
  if (!bar) scene.boundaries.push_back({"bottom", Box{{-1, -2}, {length + 3, 0}}, Fixed{{Axis::y}}});
  scene.analysis = {1, 0, QuasiStatic{load_steps}};
  scene.numerics.scheme = "TLMPM";
  scene.outputs.samples = 1;
  scene.outputs.snapshots = 1;
  return scene;
}

LoadDefinition growing(const Vector& traction) {
  EdgeTraction load;
  load.body = "block";
  load.edge = Edge::right;
  load.traction = traction;
  return {"load", load, "t"};
}

/// A bar of St Venant and Kirchhoff bears a pressure of E / sqrt(27) = 19.245 and no more: there it has become
/// 1 / sqrt(3) of its length, and beyond that it softens.
void add_limit_load(std::vector<Extreme>& extremes) {
  for (int load_steps : {1, 10, 100}) {
    Extreme extreme;
    extreme.name = "bar pressed beyond its limit load, " + std::to_string(load_steps) + " load steps";
    extreme.claim = "no equilibrium beyond the load factor 0.8";
    extreme.scene = block(Dimension::bar, "st_venant_kirchhoff", 2, load_steps);
    extreme.scene.loads = {growing({-100 / std::sqrt(27) / 0.8, 0})};
    // Cuts of a step find it to six digits.
    extreme.says = "the load factor 0.800000";
    extreme.may_stop = true;
    extremes.push_back(extreme);
  }
}

/// Williams' toggle (client/scenes/toggle_frame.textproto) of two cells, whose load is only made to grow: what
/// comes behind the snap is another equilibrium, to which nothing static leads.
void add_snap_through(std::vector<Extreme>& extremes, Size size) {
  for (int load_steps : {5, 50}) {
    if (size == Size::quick && load_steps > 5) continue;
    Extreme extreme;
    extreme.name = "toggle frame pressed beyond its snap, " + std::to_string(load_steps) + " load steps";
    extreme.claim = "balance of energy, or no equilibrium";
    Scene& scene = extreme.scene;
    scene = block(Dimension::plane_strain, "neo_hookean", 10, load_steps);
    scene.domain = {Dimension::plane_strain, {0, -2}, {10, 3}, 0.25, {}};
    scene.materials = {test::material("neo_hookean", 1000, 0.3, 1)};
    scene.bodies[0].geometry = Polygon{{{0, 0}, {10, 1.4}, {10, 1.9}, {0, 0.5}}};
    scene.bodies[0].particles_per_cell_side = 4;
    scene.boundaries = {{"clamp", Box{{0, -2}, {0, 3}}, Fixed{}},
                        {"middle", Box{{10, -2}, {10, 3}}, Fixed{{Axis::x}}}};
    scene.loads = {growing({0, -1})};
    scene.numerics.shape_functions = "quadratic_bspline";
    extreme.figure = imbalance;
    // The trapezoidal rule's, of a path that is followed.
    extreme.bound = 0.02;
    extreme.may_stop = true;
    extremes.push_back(extreme);
  }
}

/// What nothing holds is named with its motion.
void add_mechanisms(std::vector<Extreme>& extremes) {
  const auto add = [&](const char* name, const Scene& scene, const char* says) {
    Extreme extreme;
    extreme.name = name;
    extreme.claim = std::string("it is said: ") + says;
    extreme.scene = scene;
    extreme.says = says;
    extreme.may_stop = true;
    extremes.push_back(extreme);
  };
  Scene scene = block(Dimension::plane_strain, "neo_hookean", 2, 4);
  scene.loads = {growing({1, 0})};
  scene.boundaries.pop_back();
  add("block on a roller", scene, "body \"block\" can move freely along (0, 1)");
  scene.boundaries.clear();
  add("block without supports", scene, "body \"block\" can move freely in every direction and turn");
  scene.boundaries = {{"pin", Box{{0, 0}, {0, 0}}, Fixed{}}};
  add("block on one pin", scene, "body \"block\" can turn freely about (0, 0)");
  scene = block(Dimension::plane_strain, "neo_hookean", 2, 4);
  scene.loads = {growing({1, 0})};
  scene.bodies.push_back({"other", "solid", Box{{3.5, 2}, {4.5, 3}}, 2, {}});
  add("one of two bodies without supports", scene, "body \"other\" can");
  scene = block(Dimension::solid, "neo_hookean", 1, 4);
  scene.domain = {Dimension::solid, {-1, -2, -1}, {4, 4, 2}, 0.5, {}};
  scene.bodies[0].geometry = Box{{0, 0, 0}, {1, 1, 1}};
  scene.boundaries = {{"edge", Box{{0, 0, -1}, {0, 0, 2}}, Fixed{}}};
  scene.loads = {growing({1, 0, 0})};
  add("cube on a hinge", scene, "body \"block\" can turn freely about an axis along (0, 0, 1)");
}

/// A stiff block that hangs by a soft one: tangents are nearly singular, but nothing is wrong with the answer.
void add_threads(std::vector<Extreme>& extremes) {
  // Rounding of the stiff half's strains is a share of the forces that grows with the contrast.
  const std::pair<double, double> kinds[] = {
      {1e-3, 1e-8}, {1e-6, 1e-8}, {1e-9, 1e-8}, {1e-9, 1e-4}, {1e-12, 1e-8}};
  for (const auto& [ratio, tolerance] : kinds) {
    Extreme extreme;
    char name[96];
    std::snprintf(name, sizeof name, "bar of which the first half is %g times as stiff, Newton's tolerance %g",
                  ratio, tolerance);
    extreme.name = name;
    extreme.claim = "error of the end's displacement";
    Scene& scene = extreme.scene;
    scene = block(Dimension::bar, "linear_strain_elastic", 2, 1);
    std::get<QuasiStatic>(scene.analysis.kind).newton.tolerance = tolerance;
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].name = "soft";
    scene.materials[1].parameters["youngs_modulus"] *= ratio;
    scene.bodies = {{"thread", "soft", Box{{0}, {1}}, 2, {}}, {"block", "solid", Box{{1}, {2}}, 2, {}}};
    const double stretch = 0.01;
    scene.loads = {growing({stretch * 100 * ratio, 0})};
    scene.outputs.probes = {{"end", Vector{2}, {Field::displacement}, "block"}};
    // Linear in every cell, so that there is no error but what Newton's method leaves of the forces.
    extreme.bound = tolerance;
    extreme.may_stop = ratio < 1e-6 && tolerance < 1e-4;
    if (extreme.may_stop) extreme.says = "rounding alone leaves";
    const double end = 2 - 0.25 / 4;  // of the last particle
    extreme.figure = [=](const Attempt& run) {
      return run.last("end.displacement.x") / (stretch * (1 + (end - 1) * ratio)) - 1;
    };
    extremes.push_back(extreme);
  }
}

}  // namespace

std::vector<Extreme> statics(Size size) {
  std::vector<Extreme> extremes;
  add_limit_load(extremes);
  add_snap_through(extremes, size);
  add_mechanisms(extremes);
  add_threads(extremes);
  return extremes;
}

}  // namespace trajan::stability
