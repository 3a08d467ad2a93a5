#include <cmath>
#include <cstdio>

#include "solver/model/names.h"
#include "tests/stability/all_cases.h"

/// Poisson's ratios at both ends of their range: Lame's thick cylinder, whose exact displacement is known for all
/// of them. Where volume hardly changes, cells lock: the answer is too small, and gets no better with the steps.
namespace trajan::stability {

namespace {

constexpr double stiffness = 1000, pressure = 1, inner = 1, outer = 2, cell = 0.125;

/// Without axial strain; small strains, so that the exact solution is one.
Scene cylinder(double poissons_ratio, const char* shape, const char* remedy, const AnalysisKind& analysis) {
  Scene scene;
  scene.name = "cylinder";
  scene.domain = {Dimension::axisymmetric, {0, 0}, {2.5, 0.25}, cell, {}};
  scene.materials = {test::material("linear_strain_elastic", stiffness, poissons_ratio, 1)};
  scene.bodies = {{"cylinder", "solid", Box{{inner, 0}, {outer, 0.25}}, 2, {}}};
  scene.boundaries = {{"bottom", Box{{0, 0}, {2.5, 0}}, Fixed{{Axis::y}}},
                      {"top", Box{{0, 0.25}, {2.5, 0.25}}, Fixed{{Axis::y}}}};
  EdgeTraction inside;
  inside.body = "cylinder";
  inside.edge = Edge::left;
  inside.traction = {pressure, 0};
  scene.loads = {{"inside", inside, "t"}};
  scene.analysis = {1, 0, analysis};
  scene.numerics.scheme = "TLMPM";
  scene.numerics.shape_functions = shape;
  scene.numerics.locking_remedy = remedy;
  scene.outputs.samples = 1;
  scene.outputs.probes = {{"inner", Vector{inner, 0}, {Field::displacement}, ""}};
  return scene;
}

/// Of the first particle, a quarter of a cell from the surface.
double exact(double nu) {
  const double r = inner + cell / 4, a = inner * inner, b = outer * outer;
  return (1 + nu) / stiffness * pressure * a / (b - a) * ((1 - 2 * nu) * r + b / r);
}

Extreme at(double nu, const char* shape, const char* remedy, const char* kind, const AnalysisKind& analysis) {
  Extreme extreme;
  extreme.name = "Poisson's ratio " + number_text(nu) + ", " + kind + ", " + shape + ", remedy " + remedy;
  extreme.claim = "error of the displacement";
  extreme.scene = cylinder(nu, shape, remedy, analysis);
  // Second order: (cell / inner)^2 is 0.016, and displacements of linear functions err by an eighth of that.
  extreme.bound = 0.01;
  extreme.figure = [nu](const Attempt& run) { return run.last("inner.displacement.x") / exact(nu) - 1; };
  return extreme;
}

}  // namespace

std::vector<Extreme> poissons_ratios(Size size) {
  std::vector<Extreme> extremes;
  for (double nu : {-0.99, 0.0, 0.49, 0.4999, 0.499999})
    for (const char* shape : {"linear", "quadratic_bspline"})
      for (const char* remedy : {"none", "mean_dilatation"}) {
        QuasiStatic load_steps{1};
        // Rounding of strains leaves a ten-millionth of the forces.
        if (nu > 0.4999) load_steps.newton.tolerance = 1e-6;
        Extreme extreme = at(nu, shape, remedy, "load steps", load_steps);
        // Without a remedy what locks must say so.
        extreme.may_stop = remedy == std::string("none") && nu >= 0.49;
        extremes.push_back(extreme);
        if (nu > (size == Size::quick ? 0.49 : 0.4999)) continue;
        // Waves of volume are faster than those of shape by up to 70, and so many more steps are needed.
        extreme = at(nu, shape, remedy, "relaxation", Relaxation{1e-4});
        extreme.may_stop = remedy == std::string("none") && nu >= 0.49;
        extremes.push_back(extreme);
      }
  return extremes;
}

}  // namespace trajan::stability
