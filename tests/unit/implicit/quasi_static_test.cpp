#include <gmock/gmock.h>

#include <cmath>

#include "tests/unit/implicit/statics.h"

namespace trajan::quasi_static_test {
namespace {

using namespace test;

/// The force per area that stretches a neo-Hookean bar by s while its sides are free, E = 100, nu = 0.3.
double nominal_stress(double s) {
  const double mu = 100 / 2.6, lambda = 100 * 0.3 / (1.3 * 0.4);
  // The lateral stretch a from mu (a^2 - 1) + lambda ln(s a^2) = 0 by bisection.
  double low = 0.1, high = 2;
  for (int i = 0; i < 200; ++i) {
    const double a = 0.5 * (low + high);
    (mu * (a * a - 1) + lambda * std::log(s * a * a) > 0 ? high : low) = a;
  }
  return (mu * (s * s - 1) + lambda * std::log(s * low * low)) / s;
}

TEST(QuasiStatic, ABarUnderADeadForceStretchesAsItsLawSays) {
  Scene scene = block(Dimension::bar, "neo_hookean", 2, 0.25, 0.3);
  const double stretch = 1.5;
  scene.loads = {growing(traction("block", Edge::right, {nominal_stress(stretch), 0}))};
  scene.outputs.probes = {{"end", Vector{2, 0}, {Field::displacement}, ""}};
  const Model model = validate(scene);
  const Answer answer = solve(model);
  ASSERT_EQ(answer.result.end, RunEnd::finished);
  ASSERT_EQ(answer.memory.rows.size(), 3u);
  // The particle nearest to the end is a quarter of a cell from it. What is left is Newton's tolerance, 1e-8.
  const double place = 2 - 0.25 / 4;
  EXPECT_NEAR(answer.memory.rows[2][column(model, "end.displacement.x")], place * (stretch - 1), 1e-7);
}

class PatchTest : public ::testing::TestWithParam<const char*> {};

/// Where displacements are linear at the boundary they are so inside: stresses are in balance at every node,
/// however wide the functions, because particles sum up a constant exactly where cells are full.
TEST_P(PatchTest, LinearDisplacementsOfTheBoundaryAreThoseOfTheInside) {
  Scene scene = block(Dimension::plane_strain, "neo_hookean", 3, 0.25, 0.3);
  scene.numerics.shape_functions = GetParam();
  const VectorExpression linear{"t * (0.1 * x + 0.05 * y)", "t * (0.02 * x - 0.04 * y)", {}};
  scene.boundaries.clear();
  // Two cells within the body: what wide functions see of the outside is prescribed too.
  for (const Box& frame :
       {Box{{-1, -1}, {0.5, 3}}, Box{{2.5, -1}, {7, 3}}, Box{{-1, -1}, {7, 0.25}}, Box{{-1, 0.75}, {7, 3}}})
    scene.boundaries.push_back(
        {"frame" + std::to_string(scene.boundaries.size()), frame, PrescribedDisplacement{linear}});
  scene.outputs.snapshot_fields = {Field::displacement};
  const Model model = validate(scene);
  const Answer answer = solve(model);
  ASSERT_EQ(answer.result.end, RunEnd::finished);
  const std::vector<double>& moved = answer.memory.snapshots.back().fields[0];
  const std::vector<double>& before = answer.memory.snapshots.front().position;
  ASSERT_EQ(moved.size(), before.size());
  for (std::size_t p = 0; p + 1 < before.size(); p += 2) {
    // Newton's tolerance is 1e-8 of the forces; displacements are up to 0.35.
    EXPECT_NEAR(moved[p], 0.1 * before[p] + 0.05 * before[p + 1], 1e-9);
    EXPECT_NEAR(moved[p + 1], 0.02 * before[p] - 0.04 * before[p + 1], 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, PatchTest,
                         ::testing::Values("linear", "gimp", "quadratic_bspline", "cubic_bspline", "bernstein"),
                         [](const auto& shapes) { return std::string(shapes.param); });

/// A cantilever that bends far under a force at its end.
Scene cantilever(const std::string& scheme, const std::string& shapes) {
  Scene scene = block(Dimension::plane_strain, "neo_hookean", 4, 0.25, 0.3);
  scene.boundaries = {{"left", Box{{-1, -4}, {0, 3}}, Fixed{}}};
  scene.domain.lower.y = -4;
  scene.numerics.scheme = scheme;
  scene.numerics.shape_functions = shapes;
  scene.loads = {growing(traction("block", Edge::right, {0, -0.5}))};
  scene.outputs.probes = {{"tip", Vector{4, 0.5}, {Field::displacement}, ""}};
  scene.outputs.samples = 2;
  return scene;
}

TEST(QuasiStatic, ResidualsConvergeQuadratically) {
  Scene scene = cantilever("TLMPM", "linear");
  scene.analysis.kind = QuasiStatic{1, {1e-13}};
  const Model model = validate(scene);
  Executor executor(model, 1);
  executor.begin();
  QuasiStaticSteps steps(model, std::get<QuasiStatic>(model.analysis), executor, nullptr);
  // Two samples would be two steps of their own.
  for (int i = 0; !steps.advance(1, i); ++i) ASSERT_LT(i, 30);
  const std::vector<double>& residuals = steps.residuals();
  int checked = 0;
  for (std::size_t i = 1; i < residuals.size(); ++i) {
    RecordProperty("residual_" + std::to_string(i), std::to_string(residuals[i]));
    // Each is the square of the one before it times a constant, until rounding takes over. An error in the tangent
    // would make them fall by a constant factor instead, and the later bounds are out of reach.
    // Rounding leaves 1e-12, of a stiffness along the beam that is 1e4 times that across.
    if (residuals[i - 1] > 2e-3 || residuals[i - 1] < 1e-6) continue;
    ++checked;
    EXPECT_LE(residuals[i], 100 * residuals[i - 1] * residuals[i - 1]) << ::testing::PrintToString(residuals);
  }
  EXPECT_GE(checked, 1) << ::testing::PrintToString(residuals);
}

TEST(QuasiStatic, BothConfigurationsAgree) {
  double tips[2];
  for (int i = 0; i < 2; ++i) {
    const Model model = validate(cantilever(i == 0 ? "TLMPM" : "MUSL", "cubic_bspline"));
    const Answer answer = solve(model);
    ASSERT_EQ(answer.result.end, RunEnd::finished);
    tips[i] = answer.memory.rows.back()[column(model, "tip.displacement.y")];
    // The work of ten steps by the trapezoidal rule; in the updated configuration the grid's renewal costs some.
    EXPECT_NEAR(answer.memory.rows.back()[column(model, "energies.balance_error")], 0, 0.01);
  }
  EXPECT_LT(tips[0], -1.1) << "far beyond the small displacements of 0.05";
  // What ten steps and the functions' quadrature make different.
  EXPECT_NEAR(tips[1], tips[0], 2e-3 * std::abs(tips[0]));
}

}  // namespace
}  // namespace trajan::quasi_static_test
