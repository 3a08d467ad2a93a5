#include <array>
#include <cmath>
#include <cstdio>

#include "solver/model/names.h"
#include "tests/stability/all_cases.h"

/// Large deformations and motions: stretch by 10, compression to 0.05, shear by 5, turns and flights without end,
/// and bars that are pulled until their shape functions no longer see them.
namespace trajan::stability {

namespace {

constexpr double youngs_modulus = 100, poissons_ratio = 0.3;
constexpr double mu = youngs_modulus / (2 * (1 + poissons_ratio));
constexpr double lambda = youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));

/// Of a body that all nodes carry along: the stretch along x is 1 + stretch t, the shear of x along y shear t.
struct Deformation {
  const char* name;
  double stretch, shear;
};
constexpr Deformation deformations[] = {
    {"stretch by 10", 9, 0}, {"compression to 0.05", -0.95, 0}, {"shear by 5", 0, 5}};

Scene carried(const Deformation& deformation, const char* law, const char* scheme, const char* shape,
              double step) {
  Scene scene;
  scene.name = "carried";
  scene.domain = {Dimension::plane_strain, {-4, -4}, {60, 12}, 1, 1};
  scene.materials = {test::material(law, youngs_modulus, poissons_ratio, 1)};
  scene.bodies = {{"block", "solid", Box{{0, 0}, {4, 4}}, 2, {}}};
  char velocity[96];
  const bool total = scheme == std::string("TLMPM");
  std::snprintf(velocity, sizeof velocity, total ? "%g*x+%g*y" : "%g*x/(1+%g*t)+%g*y", deformation.stretch,
                total ? deformation.shear : deformation.stretch, deformation.shear);
  scene.boundaries = {{"all", Box{{-4, -4}, {60, 12}}, PrescribedVelocity{{velocity, "0"}}}};
  scene.analysis = {1, 0};
  scene.numerics.scheme = scheme;
  scene.numerics.shape_functions = shape;
  scene.numerics.time_step = step;
  scene.outputs.samples = 1;
  scene.outputs.snapshots = 1;
  scene.outputs.snapshot_fields = {Field::stress};
  return scene;
}

/// Cauchy stress xx, yy, xy at the end.
std::array<double, 3> exact_stress(const Deformation& deformation, const std::string& law) {
  const double s = 1 + deformation.stretch, g = deformation.shear;
  if (law == "neo_hookean") {
    const double pressure = lambda * std::log(s) - mu;
    return {(mu * (s * s + g * g) + pressure) / s, (mu + pressure) / s, mu * g / s};
  }
  // The Jaumann rate makes of stretch its logarithm, and of shear an oscillation (Dienes 1979).
  if (g == 0) return {(lambda + 2 * mu) * std::log(s), lambda * std::log(s), 0};
  return {mu * (1 - std::cos(g)), -mu * (1 - std::cos(g)), mu * std::sin(g)};
}

/// Largest over all particles, over the largest component.
double error_of_stress(const Attempt& run, const std::array<double, 3>& exact) {
  const std::vector<double>& stress = run.memory.snapshots.back().fields[0];
  const std::size_t width = run.model->outputs.snapshot_fields[0].width();
  double worst = 0, largest = 0;
  for (double component : exact) largest = std::max(largest, std::abs(component));
  for (std::size_t p = 0; p * width < stress.size(); ++p)
    for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(stress[p * width + c] - exact[c]));
  return worst / largest;
}

void add_carried(std::vector<Extreme>& extremes, Size size) {
  for (const Deformation& deformation : deformations)
    for (const char* law : {"linear_elastic", "neo_hookean"})
      for (const char* scheme : {"MUSL", "USL", "USF", "TLMPM"})
        for (const char* shape : {"linear", "quadratic_bspline", "gimp", "cpdi"}) {
          if (size == Size::quick && (shape != std::string("linear") || scheme == std::string("USF"))) continue;
          if (scheme == std::string("TLMPM") && shape == std::string("cpdi")) continue;
          Extreme extreme;
          extreme.name = std::string(deformation.name) + ", " + law + ", " + scheme + " " + shape;
          extreme.claim = "error of the stress";
          // F advances by 1 + step L: the error of the stretch is step / 2 times the integral of L^2, at most
          // 0.0018.
          extreme.bound = 5e-3;
          extreme.scene = carried(deformation, law, scheme, shape, 2e-4);
          const std::array<double, 3> exact = exact_stress(deformation, law);
          extreme.figure = [exact](const Attempt& run) { return error_of_stress(run, exact); };
          // Laws in rate form have no energy of their own, and where nodes carry particles through themselves,
          // velocities of particles are not theirs: both show in the balance of energy.
          extreme.may_stop = law == std::string("linear_elastic") || scheme != std::string("TLMPM");
          extremes.push_back(extreme);
        }
}

/// A bar so soft that it goes on as it began: its stretch is 1 + t everywhere.
Scene torn(const char* scheme, const char* shape) {
  Scene scene;
  scene.name = "torn";
  scene.domain = {Dimension::bar, {-50}, {50}, 0.5, {}};
  scene.materials = {test::material("neo_hookean", 1e-4, 0, 1)};
  scene.bodies = {{"bar", "solid", Box{{-4}, {4}}, 2, {"x", {}}}};
  scene.analysis = {9, 0};
  scene.numerics.scheme = scheme;
  scene.numerics.shape_functions = shape;
  // F advances by 1 + step L, whose error is step / 2 times the integral of L^2 = 1 / (1 + t)^2: a five-hundredth.
  scene.numerics.time_step = 0.005;
  scene.outputs.samples = 180;
  scene.outputs.snapshots = 1;
  scene.outputs.probes = {{"middle", Region{Box{{-1}, {1}}}, {Field::deformation_gradient}, ""}};
  return scene;
}

/// Of the stretch in the middle.
double error_of_stretch(const Attempt& run) {
  const std::vector<double> stretch = run.history("middle.deformation_gradient.xx");
  double worst = 0;
  for (std::size_t i = 0; i < stretch.size(); ++i)
    worst = std::max(worst, std::abs(stretch[i] / (1 + run.memory.times[i]) - 1));
  return worst;
}

void add_torn(std::vector<Extreme>& extremes) {
  const std::pair<const char*, const char*> kinds[] = {{"TLMPM", "linear"},
                                                       {"TLMPM", "quadratic_bspline"},
                                                       {"MUSL", "linear"},
                                                       {"MUSL", "gimp"},
                                                       {"MUSL", "cpgimp"},
                                                       {"MUSL", "cpdi"},
                                                       {"MUSL", "quadratic_bspline"},
                                                       {"MUSL", "cubic_bspline"},
                                                       {"USL", "linear"},
                                                       {"USF", "linear"}};
  for (const auto& [scheme, shape] : kinds) {
    Extreme extreme;
    extreme.name = std::string("bar stretched to 1 + t = 10, ") + scheme + " " + shape;
    extreme.claim = "error of the stretch in the middle, until it warns";
    // Far fewer particles than nodes make gradients coarse; a tenth is what one would no longer call coarse.
    extreme.bound = 0.1;
    extreme.scene = torn(scheme, shape);
    extreme.figure = error_of_stretch;
    extreme.may_stop = scheme != std::string("TLMPM");
    extremes.push_back(extreme);
  }
}

/// A free block that turns, so slowly that it hardly stretches.
Scene turning(double turns, const char* scheme, const char* shape, const char* transfer) {
  Scene scene;
  scene.name = "turning";
  scene.domain = {Dimension::plane_strain, {-2, -2}, {2, 2}, 0.25, 1};
  scene.materials = {test::material("neo_hookean", 1000, 0.3, 1)};
  scene.bodies = {{"block", "solid", Box{{-0.5, -0.5}, {0.5, 0.5}}, 2, {"-y", "x"}}};
  scene.analysis = {2 * M_PI * turns, 0};
  scene.numerics.scheme = scheme;
  scene.numerics.shape_functions = shape;
  scene.numerics.transfer = transfer;
  scene.outputs.samples = static_cast<int>(20 * turns);
  scene.outputs.snapshots = 1;
  scene.outputs.probes = {{"corner", Vector{0.5, 0.5}, {Field::position}, ""}};
  return scene;
}

double growth(const Attempt& run) {
  const std::vector<double> x = run.history("corner.position.x"), y = run.history("corner.position.y");
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    worst = std::max(worst, std::abs(std::hypot(x[i], y[i]) / std::hypot(x[0], y[0]) - 1));
  return worst;
}

void add_turns(std::vector<Extreme>& extremes, Size size) {
  const double turns = size == Size::quick ? 5 : 1000;
  const char* const kinds[][3] = {{"TLMPM", "linear", "FLIP"},
                                  {"TLMPM", "linear", "APIC"},
                                  {"MUSL", "linear", "FLIP"},
                                  {"MUSL", "gimp", "FLIP"},
                                  {"MUSL", "quadratic_bspline", "FLIP"},
                                  {"MUSL", "quadratic_bspline", "APIC"},
                                  {"MUSL", "cubic_bspline", "APIC"}};
  for (const auto& [scheme, shape, transfer] : kinds) {
    Extreme extreme;
    extreme.name = number_text(turns) + " turns, " + scheme + " " + shape + " " + transfer;
    extreme.claim = "growth of the block, until it warns";
    extreme.bound = 0.02;
    extreme.scene = turning(turns, scheme, shape, transfer);
    extreme.figure = growth;
    extreme.may_stop = true;
    extremes.push_back(extreme);
  }
}

/// A block flies whose stress is in equilibrium by itself: that of Airy's function k (x y (1 - x) (1 - y))^3,
/// which leaves the edges free, 1 % of Young's modulus at most.
Scene flying(double cells, const char* scheme, const char* shape, const char* transfer) {
  Scene scene;
  scene.name = "flying";
  const double cell = 0.125;
  scene.domain = {Dimension::plane_strain, {-0.5, -0.5}, {cells * cell + 2, 1.5}, cell, 1};
  scene.materials = {test::material("linear_elastic", 1000, 0.3, 1)};
  scene.bodies = {{"block", "solid", Box{{0, 0}, {1, 1}}, 2, {"20", {}}}};
  scene.bodies[0].initial_stress.components[0] = "10*512/3*(x*(1-x))^3*6*y*(1-y)*(1-5*y+5*y^2)";
  scene.bodies[0].initial_stress.components[1] = "10*512/3*(y*(1-y))^3*6*x*(1-x)*(1-5*x+5*x^2)";
  scene.bodies[0].initial_stress.components[3] = "0-9*10*512/3*(1-2*x)*(x*(1-x))^2*(1-2*y)*(y*(1-y))^2";
  scene.analysis = {cells * cell / 20, 0};
  scene.numerics.scheme = scheme;
  scene.numerics.shape_functions = shape;
  scene.numerics.transfer = transfer;
  scene.outputs.samples = 100;
  scene.outputs.snapshots = 1;
  scene.outputs.probes = {{"centre", Region{Box{{0.4, 0.4}, {0.6, 0.6}}}, {Field::stress}, ""}};
  return scene;
}

double lost_stress(const Attempt& run) {
  const std::vector<double> stress = run.history("centre.stress.xx");
  double worst = 0;
  for (double value : stress) worst = std::max(worst, std::abs(value / stress[0] - 1));
  return worst;
}

void add_flights(std::vector<Extreme>& extremes, Size size) {
  const double cells = size == Size::quick ? 100 : 1e4;
  for (const char* transfer : {"FLIP", "APIC"})
    for (const char* shape : {"linear", "gimp", "cpdi", "quadratic_bspline", "cubic_bspline"}) {
      const bool product = shape != std::string("linear") && shape != std::string("cpdi");
      if (transfer == std::string("APIC") && !product) continue;
      Extreme extreme;
      extreme.name = "flight over " + number_text(cells) + " cells, MUSL " + shape + " " + transfer;
      extreme.claim = "change of the residual stress";
      // 0.15 of the energy, from which on the run warns, is that of noise of 0.39 times the stress.
      extreme.bound = 0.4;
      extreme.scene = flying(cells, "MUSL", shape, transfer);
      extreme.figure = lost_stress;
      extreme.may_stop = true;
      extremes.push_back(extreme);
    }
}

}  // namespace

std::vector<Extreme> deformations_and_motions(Size size) {
  std::vector<Extreme> extremes;
  add_carried(extremes, size);
  add_torn(extremes);
  add_turns(extremes, size);
  add_flights(extremes, size);
  return extremes;
}

}  // namespace trajan::stability
