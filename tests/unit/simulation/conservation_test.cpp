#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/epsilon.h"
#include "tests/unit/simulation/scenes.h"

namespace trajan {
namespace {

using test::epsilon;

class Conservation : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Schemes, Conservation, testing::Values("USL", "MUSL", "TLMPM"),
                         [](const auto& named) { return named.param; });

TEST_P(Conservation, KeepsMomentumThroughACollision) {
  Scene scene = test::discs(0.04);
  scene.numerics.scheme = GetParam();
  // Unequal velocities, so that there is momentum to be lost.
  scene.bodies[0].initial_velocity = {"0.13", "0.1"};
  const Model model = validate(scene);
  test::Memory memory;
  const RunResult result = run(model, {}, memory, nullptr);
  ASSERT_EQ(result.end, RunEnd::finished);
  const std::size_t x = test::column(model, "momentum.x"), y = test::column(model, "momentum.y");
  // Each step rounds the momentum of every particle and node, all of one sign in the worst case: some eps
  // of the sum of the magnitudes m |v|.
  const double magnitude = 2 * 1000 * 0.1257 * 0.2;
  const double tolerance = 4 * epsilon * magnitude * static_cast<double>(result.progress.step);
  for (const std::vector<double>& row : memory.rows) {
    EXPECT_NEAR(row[x], memory.rows[0][x], tolerance);
    EXPECT_NEAR(row[y], memory.rows[0][y], tolerance);
  }
}

/// Schemes in which bodies meet: shape functions of current positions.
class Collision : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Schemes, Collision, testing::Values("USL", "MUSL"),
                         [](const auto& named) { return named.param; });

TEST_P(Collision, GivesBackMostOfTheEnergy) {
  Scene scene = test::discs(0.04);
  scene.numerics.scheme = GetParam();
  const Model model = validate(scene);
  test::Memory memory;
  ASSERT_EQ(run(model, {}, memory, nullptr).end, RunEnd::finished);
  const std::size_t kinetic = test::column(model, "energies.kinetic"),
                    strain = test::column(model, "energies.strain");
  double largest_strain = 0;
  for (const std::vector<double>& row : memory.rows) largest_strain = std::max(largest_strain, row[strain]);
  // Discs that meet head on come to rest for a moment, and part again with some of it left as vibration
  // (Sulsky, Chen and Schreyer 1994, figure 5b).
  EXPECT_GT(largest_strain, 0.7 * memory.rows[0][kinetic]);
  EXPECT_GT(memory.rows.back()[kinetic], 0.7 * memory.rows[0][kinetic]);
}

TEST_P(Conservation, KeepsTheEnergyOfAVibratingBar) {
  for (const char* law : {"linear_elastic", "neo_hookean"}) {
    Scene scene = test::bar(GetParam(), law, 0.5, 0.1);
    scene.analysis.end_time = 12;  // three periods
    const Model model = validate(scene);
    test::Memory memory;
    ASSERT_EQ(run(model, {}, memory, nullptr).end, RunEnd::finished);
    const std::size_t error = test::column(model, "energies.balance_error");
    // The product's promise for this problem.
    for (const std::vector<double>& row : memory.rows) EXPECT_LT(std::abs(row[error]), 0.01) << law;
  }
}

TEST(Blend, OfPicLosesEnergyAndKeepsMomentum) {
  Scene scene = test::discs(0.04);
  scene.numerics.flip_fraction = 0.9;
  scene.bodies[0].initial_velocity = {"0.13", "0.1"};
  const Model model = validate(scene);
  test::Memory memory;
  const RunResult result = run(model, {}, memory, nullptr);
  ASSERT_EQ(result.end, RunEnd::finished);
  const std::size_t x = test::column(model, "momentum.x"), total = test::column(model, "energies.total");
  // As above.
  const double tolerance = 4 * epsilon * 2 * 1000 * 0.1257 * 0.2 * static_cast<double>(result.progress.step);
  EXPECT_NEAR(memory.rows.back()[x], memory.rows[0][x], tolerance);
  EXPECT_LT(memory.rows.back()[total], 0.95 * memory.rows[0][total]);
}

}  // namespace
}  // namespace trajan
