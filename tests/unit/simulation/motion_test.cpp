#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/epsilon.h"
#include "tests/unit/simulation/scenes.h"

namespace trajan::motion_test {
namespace {

using test::epsilon;

/// Every scheme with every law.
class Motion : public testing::TestWithParam<std::tuple<std::string, std::string>> {
 protected:
  std::string scheme() const { return std::get<0>(GetParam()); }
  std::string law() const { return std::get<1>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Schemes, Motion,
                         testing::Combine(testing::Values("USL", "MUSL", "TLMPM"),
                                          testing::Values("linear_elastic", "neo_hookean")),
                         [](const auto& named) {
                           return std::get<0>(named.param) + "_" + std::get<1>(named.param);
                         });

/// A free block.
Scene block(const std::string& scheme, const std::string& law) {
  Scene scene;
  scene.name = "block";
  scene.domain = {Dimension::plane_strain, {-10, -10}, {10, 10}, 0.5, 1};
  scene.materials = {test::material(law, 100, 0.3, 2)};
  scene.bodies = {{"block", "solid", Box{{0, 0}, {2, 1}}, 2, {}}};
  scene.analysis = {3, 0};
  scene.numerics.scheme = scheme;
  scene.outputs.samples = 30;
  scene.outputs.snapshots = 1;
  return scene;
}

TEST_P(Motion, CarriesARigidTranslationExactly) {
  Scene scene = block(scheme(), law());
  scene.bodies[0].initial_velocity = {"1.3", "-0.7"};
  const Model model = validate(scene);
  test::Memory memory;
  const RunResult result = run(model, {}, memory, nullptr);
  ASSERT_EQ(result.end, RunEnd::finished);
  const Snapshot& last = memory.snapshots.back();
  const std::vector<double>& displacement = last.fields.at(0);
  const std::vector<double>& stress = last.fields.at(1);
  // A node's velocity is a quotient of sums of some ten terms, and their rounding makes a strain of that
  // over the cell size in every step.
  const auto steps = static_cast<double>(result.progress.step);
  const double rounding = 16 * epsilon * steps;
  for (std::size_t p = 0; p < last.position.size() / 2; ++p) {
    EXPECT_NEAR(displacement[2 * p], 3.9, 3.9 * rounding);
    EXPECT_NEAR(displacement[2 * p + 1], -2.1, 3.9 * rounding);
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(stress[4 * p + c], 0, 135 * 3.9 / 0.5 * rounding);
  }
}

TEST_P(Motion, FallsOnTheParabola) {
  Scene scene = block(scheme(), law());
  scene.bodies[0].initial_velocity = {"0", "2"};
  scene.loads = {{"gravity", BodyForce{{0, -1.5}, {}}}};
  scene.outputs.probes = {{"one", Vector{1, 0.5}, {Field::displacement, Field::velocity}, ""}};
  const Model model = validate(scene);
  test::Memory memory;
  const RunResult result = run(model, {}, memory, nullptr);
  ASSERT_EQ(result.end, RunEnd::finished);
  // Leapfrog is exact for a constant acceleration; what is left is rounding.
  const double rounding = 64 * epsilon * static_cast<double>(result.progress.step);
  for (std::size_t row = 0; row < memory.rows.size(); ++row) {
    const double t = memory.times[row];
    EXPECT_NEAR(memory.rows[row][test::column(model, "one.displacement.y")], 2 * t - 0.75 * t * t, 6 * rounding);
    EXPECT_NEAR(memory.rows[row][test::column(model, "one.velocity.y")], 2 - 1.5 * t, 6 * rounding);
  }
}

TEST_P(Motion, AccumulatesTheImpulseOfAPointForce) {
  Scene scene = block(scheme(), law());
  scene.loads = {{"push", PointForce{"block", {2, 0.9}, {0.03, 0.02}}}};
  const Model model = validate(scene);
  test::Memory memory;
  const RunResult result = run(model, {}, memory, nullptr);
  ASSERT_EQ(result.end, RunEnd::finished);
  // Weights add up to 1 to rounding in every step.
  const double rounding = 8 * epsilon * static_cast<double>(result.progress.step);
  EXPECT_NEAR(memory.rows.back()[test::column(model, "momentum.x")], 0.09, rounding);
  EXPECT_NEAR(memory.rows.back()[test::column(model, "momentum.y")], 0.06, rounding);
}

TEST_P(Motion, SettlesToTheStaticAnswerWithDamping) {
  Scene scene = test::bar(scheme(), law(), 0.5, 0);
  const double omega = std::numbers::pi / 20 * 10;
  scene.analysis = {20, 2 * omega};
  scene.loads = {{"pull", EdgeTraction{"bar", Edge::right, {0.01, 0}, ""}, Ramp{0, 8, true}}};
  const Model model = validate(scene);
  test::Memory memory;
  ASSERT_EQ(run(model, {}, memory, nullptr).end, RunEnd::finished);
  // u = t x / E at the tip particle, x = 9.875. Strains are 1e-4, so that second order effects are 1e-4 of
  // the answer, and exp(-omega 12) of the transient is left; the traction acts at the end of the edge.
  EXPECT_NEAR(memory.rows.back()[test::column(model, "tip.displacement.x")], 1e-4 * 9.875, 1e-3 * 1e-3);
}

TEST_P(Motion, DoesTheWorkOfAPrescribedVelocity) {
  Scene scene = test::bar(scheme(), law(), 0.5, 0);
  scene.boundaries.push_back({"right", Box{{10, -2}, {10, 3}}, PrescribedVelocity{{"0.02*t", {}}}});
  scene.analysis = {2, 0};
  const Model model = validate(scene);
  test::Memory memory;
  ASSERT_EQ(run(model, {}, memory, nullptr).end, RunEnd::finished);
  const std::vector<double>& last = memory.rows.back();
  EXPECT_GT(last[test::column(model, "energies.work")], 1e-4);
  // Leapfrog's error of second order in time and the grid's own dissipation, some per cent at this resolution.
  EXPECT_NEAR(last[test::column(model, "energies.balance_error")], 0, 0.05);
}

/// Largest error of the tip's displacement over the amplitude for the first axial mode.
double bar_error(const std::string& scheme, const std::string& law, double cell) {
  Scene scene = test::bar(scheme, law, cell, 0.01);
  scene.outputs.probes[0].where = Vector{5.125, 0.5};
  const Model model = validate(scene);
  test::Memory memory;
  EXPECT_EQ(run(model, {}, memory, nullptr).end, RunEnd::finished);
  const std::size_t column = test::column(model, "tip.displacement.x");
  const Vector at =
      model.bodies[0].lattice.point(model.outputs.probes[0].particles[0] % model.bodies[0].lattice.columns, 0);
  const double omega = std::numbers::pi / 20 * 10, amplitude = 0.01 / omega;
  double worst = 0;
  for (std::size_t row = 0; row < memory.rows.size(); ++row) {
    const double exact = amplitude * std::sin(std::numbers::pi * at.x / 20) * std::sin(omega * memory.times[row]);
    worst = std::max(worst, std::abs(memory.rows[row][column] - exact) / amplitude);
  }
  return worst;
}

TEST_P(Motion, ConvergesToTheExactAxialMode) {
  const double coarse = bar_error(scheme(), law(), 1), middle = bar_error(scheme(), law(), 0.5);
  const double fine = bar_error(scheme(), law(), 0.25);
  RecordProperty("orders",
                 std::to_string(std::log2(coarse / middle)) + " " + std::to_string(std::log2(middle / fine)));
  EXPECT_LT(fine, 0.01);
  // Linear functions and leapfrog promise order 2 while no particle crosses a cell.
  EXPECT_GT(std::log2(coarse / fine) / 2, 1.5) << coarse << " " << middle << " " << fine;
}

}  // namespace
}  // namespace trajan::motion_test
