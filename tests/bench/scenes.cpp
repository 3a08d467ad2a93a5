#include "tests/bench/scenes.h"

#include <cmath>
#include <numbers>

namespace trajan::bench {
namespace {

Scene scene_of(const Choice& choice, double cell) {
  Scene scene;
  scene.name = "bench";
  scene.domain.dimension = choice.dimension;
  scene.domain.cell_size = cell;
  scene.materials = {{"solid", 1000, choice.law, {{"youngs_modulus", 1000}, {"poissons_ratio", 0.3}}}};
  // Strong enough that nothing breaks: what is measured is the law's work.
  if (choice.damage) scene.materials[0].damage = {{"compressive_strength", 1e4}, {"shape", 3}};
  scene.numerics.scheme = choice.scheme;
  scene.numerics.shape_functions = choice.shape_functions;
  scene.numerics.transfer = choice.transfer;
  scene.numerics.precision = choice.precision;
  scene.analysis.end_time = 1000;  // no sample comes while it is measured
  scene.outputs.samples = 1;
  scene.outputs.snapshots = 1;
  return scene;
}

void load(Scene& scene, Edge edge, const Vector& traction, const std::string& time) {
  EdgeTraction load;
  load.body = scene.bodies[0].name, load.edge = edge, load.traction = traction;
  scene.loads = {{"load", load, time}};
}

}  // namespace

Scene discs(const Choice& choice, double particles) {
  const double area = 2 * std::numbers::pi * 0.2 * 0.2;
  Scene scene = scene_of(choice, 1 / std::round(std::sqrt(particles / (4 * area))));
  scene.domain.lower = {-100, -100}, scene.domain.upper = {101, 101};
  scene.bodies = {{"one", "solid", Disc{{0.2, 0.2}, 0.2}, 2, {"0.1", "0.1"}},
                  {"two", "solid", Disc{{0.8, 0.8}, 0.2}, 2, {"-0.1", "-0.1"}}};
  if (choice.turned) {
    scene.bodies[0].initial_velocity = {"0.2 - y", "x - 0.2"};
    scene.bodies[1].initial_velocity = {"0.8 - y", "x - 0.8"};
  }
  if (choice.contact) scene.contacts = {{{}, 0.2}};
  return scene;
}

Scene block(const Choice& choice, double particles) {
  const bool solid = choice.dimension == Dimension::solid;
  const double per_side = solid ? std::cbrt(particles) : std::sqrt(particles);
  Scene scene = scene_of(choice, 1 / std::round(per_side / 2));
  const double room = 4 * scene.domain.cell_size, top = solid ? 1 : 0;
  const double left = choice.dimension == Dimension::axisymmetric ? 0 : -room;
  const Vector lower{left, 0, solid ? -room : 0}, upper{1 + room, 1 + room, solid ? 1 + room : 0};
  scene.domain.lower = lower, scene.domain.upper = upper;
  scene.bodies = {{"block", "solid", Box{{}, {1, 1, top}}, 2, {"0", "1e-3 * y"}}};
  scene.boundaries = {{"ground", Edge::bottom, Fixed{{Axis::y}}}};
  if (choice.drifting) {
    scene.domain.upper.x = 100;
    scene.bodies[0].initial_velocity = {"0.1", "1e-3 * y"};
  }
  if (choice.loaded) load(scene, Edge::top, {0, 0.1}, "sin(t)");
  return scene;
}

Scene bar(const Choice& choice, double particles) {
  Scene scene = scene_of(choice, 1 / std::round(std::sqrt(particles / (4 * 8))));
  scene.domain.lower = {0, -4}, scene.domain.upper = {16, 5};
  scene.bodies = {{"bar", "solid", Box{{0, 0}, {8, 1}}, 2, {"1e-3 * x", "0"}}};
  scene.boundaries = {{"wall", Edge::left, Fixed{}}};
  if (choice.loaded) load(scene, Edge::right, {0.1, 0}, "sin(t)");
  if (choice.kind == Kind::explicit_steps) return scene;

  scene.bodies[0].initial_velocity = {};
  scene.outputs.samples = choice.kind == Kind::modal ? 5 : 1;
  scene.analysis.end_time = 1;
  if (choice.kind == Kind::modal) {
    scene.analysis.kind = Modal{};
    return scene;
  }
  load(scene, Edge::right, {0, -0.1}, "t");
  if (choice.kind == Kind::implicit_static)
    scene.analysis.kind = QuasiStatic{.load_steps = 3};
  else
    scene.analysis.kind = ImplicitDynamics{.time_steps = 3};
  return scene;
}

}  // namespace trajan::bench
