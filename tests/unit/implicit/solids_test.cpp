#include <gmock/gmock.h>

#include <cmath>

#include "solver/implicit/step_balance.h"
#include "tests/unit/implicit/statics.h"

/// Implicit analyses in axisymmetric scenes and in space, and pressure that follows.
namespace trajan {
namespace {

using namespace test;

Pressure pressure_on(Edge edge, double value) {
  Pressure pressure;
  pressure.surface = {"block", edge, {}};
  pressure.pressure = value;
  return pressure;
}

struct Case {
  const char* name;
  Dimension dimension;
  const char* scheme;
};

/// A block under pressures that follow it.
Scene pressed(const Case& of) {
  const bool solid = of.dimension == Dimension::solid;
  Scene scene;
  scene.name = "block";
  scene.domain = {of.dimension, {0, -1, solid ? -1.0 : 0}, {3, 3, solid ? 3.0 : 0}, 0.5};
  scene.materials = {material("neo_hookean", 100, 0.3, 1)};
  scene.bodies = {{"block", "solid", Box{{0.5, 0.5, solid ? 0.5 : 0}, {1.5, 1.5, solid ? 1.5 : 0}}, 2, {}}};
  scene.analysis = {1, 0, QuasiStatic{}};
  scene.numerics.scheme = of.scheme;
  scene.loads = {{"side", pressure_on(Edge::right, 30), 1.0}, {"top", pressure_on(Edge::top, -20), 1.0}};
  if (solid) scene.loads.push_back({"back", pressure_on(Edge::back, 10), 1.0});
  return scene;
}

class FollowingPressure : public ::testing::TestWithParam<Case> {};

TEST_P(FollowingPressure, HasItsShareOfTheTangent) {
  const Model model = validate(pressed(GetParam()));
  Executor executor(model, 1);
  executor.begin();
  const GridView view(model, executor);
  Responses responses(model, executor);
  StepBalance balance(model, executor, view, responses, 0, 1, 1);
  const auto some = [&](double size, double phase) {
    Eigen::VectorXd u(static_cast<Eigen::Index>(view.on.unknowns()));
    for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = 0.5 * size * std::sin(phase + 2.3 * static_cast<double>(i));
    return u;
  };
  const Eigen::VectorXd at = some(0.1, 2), along = some(1, 3);
  const double step = 1e-6;
  const auto residual_at = [&](const Eigen::VectorXd& u) {
    EXPECT_TRUE(balance.evaluate(u));
    return balance.residual();
  };
  const Eigen::VectorXd difference =
      (residual_at(at - step * along) - residual_at(at + step * along)) / (2 * step);
  residual_at(at);
  const SparseMatrix tangent = balance.tangent();
  // Differences leave the square of the step, and rounding over the step: 1e-10.
  EXPECT_LT((tangent * along - difference).norm(), 1e-8 * difference.norm());
  EXPECT_GT((tangent - SparseMatrix(tangent.transpose())).norm(), 1e-3 * tangent.norm()) << "the loads' share";
}

INSTANTIATE_TEST_SUITE_P(Cases, FollowingPressure,
                         ::testing::Values(Case{"PlaneStrain", Dimension::plane_strain, "TLMPM"},
                                           Case{"PlaneStrainUpdated", Dimension::plane_strain, "MUSL"},
                                           Case{"Axisymmetric", Dimension::axisymmetric, "TLMPM"},
                                           Case{"AxisymmetricUpdated", Dimension::axisymmetric, "MUSL"},
                                           Case{"Solid", Dimension::solid, "TLMPM"},
                                           Case{"SolidUpdated", Dimension::solid, "MUSL"}),
                         [](const auto& of) { return std::string(of.param.name); });

/// The error of the radial displacement at the bore of Lamé's cylinder, radii 1 and 2, under a small pressure.
double lame_error(double poissons_ratio, const char* remedy, const char* scheme) {
  Scene scene;
  scene.name = "cylinder";
  scene.domain = {Dimension::axisymmetric, {0, 0}, {3, 0.25}, 0.125};
  scene.materials = {material("neo_hookean", 100, poissons_ratio, 1)};
  scene.bodies = {{"block", "solid", Box{{1, 0}, {2, 0.25}}, 2, {}}};
  scene.boundaries = {{"ends", Box{{0, 0}, {3, 0.25}}, Fixed{{Axis::y}}}};
  scene.analysis = {1, 0, QuasiStatic{1}};
  scene.numerics.scheme = scheme;
  scene.numerics.locking_remedy = remedy;
  scene.loads = {growing(pressure_on(Edge::left, 0.01))};
  scene.outputs.probes = {{"bore", Vector{1, 0}, {Field::displacement}, ""}};
  scene.outputs.samples = 1;
  const Model model = validate(scene);
  const Answer answer = solve(model);
  EXPECT_EQ(answer.result.end, RunEnd::finished);
  const double r = 1 + 0.125 / 4, found = answer.memory.rows.back()[column(model, "bore.displacement.x")];
  const double exact = (1 + poissons_ratio) / 100 * 0.01 / 3 * ((1 - 2 * poissons_ratio) * r + 4 / r);
  return found / exact - 1;
}

TEST(Axisymmetric, LamesCylinderWidensAsItShould) {
  for (const char* scheme : {"TLMPM", "MUSL"}) {
    // Eight cells over the wall leave about (1 / 8)^2 / 24; strains of 1e-4 are nearly linear.
    EXPECT_NEAR(lame_error(0.3, "none", scheme), 0, 2e-3);
    EXPECT_LT(lame_error(0.4999, "none", scheme), -0.5) << "locked";
    EXPECT_NEAR(lame_error(0.4999, "mean_dilatation", scheme), 0, 5e-3);
  }
}

TEST(Solid, LinearDisplacementsOfTheBoundaryAreThoseOfTheInside) {
  for (const char* remedy : {"none", "mean_dilatation"}) {
    Scene scene;
    scene.name = "cube";
    scene.domain = {Dimension::solid, {-1, -1, -1}, {2, 2, 2}, 0.25};
    scene.materials = {material("neo_hookean", 100, 0.3, 1)};
    scene.bodies = {{"block", "solid", Box{{0, 0, 0}, {1, 1, 1}}, 2, {}}};
    const VectorExpression linear{"t * (0.1 * x + 0.05 * y)", "t * (0.02 * x - 0.04 * z)", "t * 0.06 * (z - x)"};
    for (int axis = 0; axis < 3; ++axis)
      for (double side : {0.0, 1.0}) {
        Vector lower{-1, -1, -1}, upper{2, 2, 2};
        (axis == 0 ? lower.x : axis == 1 ? lower.y : lower.z) = side;
        (axis == 0 ? upper.x : axis == 1 ? upper.y : upper.z) = side;
        scene.boundaries.push_back(
            {"face" + std::to_string(scene.boundaries.size()), Box{lower, upper}, PrescribedDisplacement{linear}});
      }
    scene.analysis = {1, 0, QuasiStatic{2}};
    scene.numerics.scheme = "TLMPM";
    scene.numerics.locking_remedy = remedy;
    scene.outputs.samples = 1;
    scene.outputs.snapshots = 1;
    scene.outputs.snapshot_fields = {Field::displacement};
    const Answer answer = solve(validate(scene));
    ASSERT_EQ(answer.result.end, RunEnd::finished);
    const std::vector<double>& moved = answer.memory.snapshots.back().fields[0];
    const std::vector<double>& before = answer.memory.snapshots.front().position;
    ASSERT_EQ(moved.size(), before.size());
    for (std::size_t p = 0; p + 2 < before.size(); p += 3) {
      const double x = before[p], y = before[p + 1], z = before[p + 2];
      // Newton's tolerance is 1e-8 of the forces.
      EXPECT_NEAR(moved[p], 0.1 * x + 0.05 * y, 1e-9);
      EXPECT_NEAR(moved[p + 1], 0.02 * x - 0.04 * z, 1e-9);
      EXPECT_NEAR(moved[p + 2], 0.06 * (z - x), 1e-9);
    }
  }
}

}  // namespace
}  // namespace trajan
