#include <algorithm>
#include <cmath>

#include "tests/stability/all_cases.h"

/// Where particles of floats stop being as good as doubles: the same scene with both, and how far their histories
/// are apart.
namespace trajan::stability {

namespace {

/// Largest difference of a history from that with doubles, over the largest value of that.
double difference(const Attempt& run, Scene scene, const std::string& column) {
  scene.numerics.precision = "DOUBLE";
  const std::vector<double> wide = attempt(scene).history(column), narrow = run.history(column);
  double largest = 0, worst = 0;
  for (std::size_t i = 0; i < wide.size(); ++i) {
    largest = std::max(largest, std::abs(wide[i]));
    worst = std::max(worst, std::abs(narrow[i] - wide[i]));
  }
  return worst / largest;
}

Extreme compared(const std::string& name, const std::string& column, double bound, Scene scene) {
  scene.numerics.precision = float_precision;
  Extreme extreme;
  extreme.name = name;
  extreme.claim = "difference of " + column + " from doubles";
  extreme.bound = bound;
  extreme.scene = scene;
  // Of what both do: in 10^6 steps MUSL loses 2 % of a vibration's energy.
  extreme.may_warn = true;
  extreme.figure = [scene, column](const Attempt& run) { return difference(run, scene, column); };
  return extreme;
}

/// A bar of 20 cells of unit wave speed 10 and density 1; half of what a wave takes through a cell is a step.
Scene bar(const char* scheme, const char* law, double steps, double from = 0) {
  Scene scene = test::bar(scheme, law, 0.5, 0);
  scene.domain = {Dimension::bar, {from - 2}, {from + 12}, 0.5, {}};
  scene.bodies[0].geometry = Box{{from}, {from + 10}};
  scene.boundaries[0].nodes = Box{{from}, {from}};
  scene.outputs.probes[0].where = Vector{from + 10};
  scene.analysis.end_time = steps * 0.5 * 0.5 / 10;
  scene.outputs.samples = 200;
  return scene;
}

/// Its first mode, whose strains are a thirtieth of the velocity.
Scene vibration(const char* scheme, const char* law, double steps, double velocity, double from = 0) {
  Scene scene = bar(scheme, law, steps, from);
  scene.bodies[0].initial_velocity.x =
      std::to_string(velocity * 1e9) + "*1e-9*sin(pi*(x-" + std::to_string(from) + ")/20)";
  return scene;
}

/// Pulled at its end by a force that grows all the time to a strain of a thousandth: a body that hardly moves.
Scene creep(const char* scheme, const char* law, double steps) {
  Scene scene = bar(scheme, law, steps);
  scene.loads = {{"pull", PointForce{"bar", {10}, {0.1}}, Ramp{0, scene.analysis.end_time}}};
  return scene;
}

/// A cantilever in a plane that swings, where laws are computed in floats. By less than its particles have to the
/// next cell: one that comes to light nodes a step earlier or later may change its motion by some thousandths.
Scene swing(const char* scheme, const char* law, double steps) {
  Scene scene = bar(scheme, law, steps);
  scene.domain = {Dimension::plane_strain, {-2, -4}, {12, 5}, 0.5, 1};
  scene.materials = {test::material(law, 100, 0.3, 1)};
  scene.bodies[0].geometry = Box{{0, 0}, {10, 1}};
  scene.bodies[0].initial_velocity.y = "1e-4*x^2";
  scene.boundaries = {{"wall", Box{{0, -4}, {0, 5}}, Fixed{}}};
  scene.outputs.probes[0].where = Vector{10, 0.5};
  return scene;
}

/// A bar that falls freely, from rest. Not through cells, where linear functions make noise of any rounding.
Scene fall(double steps) {
  Scene scene = bar("TLMPM", "linear_elastic", steps);
  const double end = scene.analysis.end_time;
  scene.boundaries.clear();
  scene.domain.upper = {112};
  scene.loads = {{"gravity", BodyForce{{200 / (end * end)}, {}}}};
  return scene;
}

}  // namespace

std::vector<Extreme> floats(Size size) {
  // What the README promises for as many steps as most runs take.
  constexpr double promise = 1e-3;
  const bool whole = size == Size::whole;
  const char *tip = "tip.displacement.x", *velocity = "tip.velocity.x";
  std::vector<Extreme> extremes;
  for (const double steps : whole ? std::vector<double>{1e4, 1e5, 1e6} : std::vector<double>{1e4}) {
    const auto name = [steps](const char* what) {
      return std::string(what) + ", 10^" + std::to_string(static_cast<int>(std::log10(steps))) + " steps";
    };
    for (const auto& [scheme, law] : {std::pair{"MUSL", "linear_elastic"}, {"TLMPM", "neo_hookean"}}) {
      const std::string kind = std::string(scheme) + " " + law + ": ";
      const auto add = [&](const std::string& what, const char* column, const Scene& scene) {
        extremes.push_back(compared(kind + name(what.c_str()), column, promise, scene));
      };
      add("vibration, strains of 3e-3", tip, vibration(scheme, law, steps, 0.1));
      add("vibration, strains of 3e-8", tip, vibration(scheme, law, steps, 1e-6));
      add("vibration, 10^6 cells from the origin", tip, vibration(scheme, law, steps, 0.1, 5e5));
      add("force that grows all the time", tip, creep(scheme, law, steps));
      if (steps < 1e6) add("cantilever that swings", "tip.displacement.y", swing(scheme, law, steps));
    }
  }
  for (const double steps : whole ? std::vector<double>{1e5, 1e6} : std::vector<double>{1e5})
    extremes.push_back(compared("free fall, 10^" + std::to_string(static_cast<int>(std::log10(steps))) + " steps",
                                velocity, promise, fall(steps)));
  return extremes;
}

}  // namespace trajan::stability
