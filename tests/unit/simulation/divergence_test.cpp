#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/schemes/time_step.h"
#include "tests/unit/simulation/scenes.h"

namespace trajan {
namespace {

using testing::HasSubstr;

class Stability : public testing::TestWithParam<std::tuple<std::string, std::string>> {};
INSTANTIATE_TEST_SUITE_P(Schemes, Stability,
                         testing::Combine(testing::Values("USL", "MUSL", "TLMPM"),
                                          testing::Values("linear_elastic", "neo_hookean")),
                         [](const auto& named) {
                           return std::get<0>(named.param) + "_" + std::get<1>(named.param);
                         });

TEST_P(Stability, EndsAsDivergedWithAStepBeyondTheLimit) {
  Model model = validate(test::bar(std::get<0>(GetParam()), std::get<1>(GetParam()), 0.5, 0.1));
  // The limit is that of nodes that move independently; mapping velocities twice, as MUSL and TLMPM do,
  // halves the highest frequency of a bar, along which waves are slower by sqrt(2) as well.
  model.numerics.time_step = 4 * time_step_limit(model).value;
  model.end_time = 100;
  test::Memory memory;
  const RunResult result = run(model, {}, memory, nullptr);
  ASSERT_EQ(result.end, RunEnd::diverged);
  ASSERT_TRUE(result.divergence);
  EXPECT_GT(result.divergence->step, 0);
  EXPECT_GT(result.divergence->time, 0);
  EXPECT_GE(result.divergence->particle, 0);
  EXPECT_LT(result.divergence->particle, model.particle_count());
  EXPECT_FALSE(result.divergence->cause.empty());
  EXPECT_THAT(result.divergence->remedy, HasSubstr("time_step_fraction"));
  for (const std::vector<double>& row : memory.rows)
    for (double value : row) EXPECT_TRUE(std::isfinite(value));
}

TEST_P(Stability, IsStableAtTheWholeLimit) {
  Scene scene = test::bar(std::get<0>(GetParam()), std::get<1>(GetParam()), 0.5, 0.1);
  scene.numerics.time_step_fraction = 1;
  scene.analysis.end_time = 40;  // ten periods
  const Model model = validate(scene);
  test::Memory memory;
  ASSERT_EQ(run(model, {}, memory, nullptr).end, RunEnd::finished);
  // Instability multiplies the energy in every step; what is lost or gained without it is small.
  const std::size_t total = test::column(model, "energies.total");
  EXPECT_NEAR(memory.rows.back()[total], memory.rows[0][total], 0.05 * memory.rows[0][total]);
}

TEST(Leaving, TheDomainIsDivergence) {
  Scene scene = test::discs(0.04);
  scene.bodies.pop_back();
  scene.bodies[0].initial_velocity = {"-0.5", {}};
  const Model model = validate(scene);
  test::Memory memory;
  const RunResult result = run(model, {}, memory, nullptr);
  ASSERT_EQ(result.end, RunEnd::diverged);
  EXPECT_THAT(result.divergence->cause, HasSubstr("left the domain"));
  EXPECT_THAT(result.divergence->remedy, HasSubstr("domain"));
  // The disc touches x = 0 from the beginning: its leftmost particles leave first.
  ASSERT_FALSE(memory.snapshots.empty());
  const double x = memory.snapshots[0].position.at(2 * static_cast<std::size_t>(result.divergence->particle));
  EXPECT_LT(x, 0.01 + 0.5 * result.divergence->time + 0.02);
}

/// A bar whose highest row of particles is at y = 0.875, and so is a row of nodes.
Scene bar_on_faces(const std::string& shape, double lowest) {
  Scene scene = test::bar("TLMPM", "linear_elastic", 0.5, 0.1);
  scene.materials = {test::material("linear_elastic", 100, 0.3, 1)};
  scene.bodies[0].geometry = Box{{0, lowest}, {10, 1}};
  scene.domain.lower.y = -1.625;
  scene.domain.upper.y = 2.375;
  scene.numerics.shape_functions = shape;
  return scene;
}

TEST(Surfaces, OnFacesOfCellsBelongToTheCellsThatHaveTheBody) {
  for (const char* shape : {"linear", "bernstein"})
    // With the rows of particles on faces, in the middle and at the end of elements of two cells.
    for (double shift : {0.0, 0.5}) {
      Scene scene = bar_on_faces(shape, 0);
      scene.domain.lower.y -= shift;
      scene.domain.upper.y -= shift;
      const Model model = validate(scene);
      test::Memory memory;
      const RunResult result = run(model, {}, memory, nullptr);
      ASSERT_EQ(result.end, RunEnd::finished) << result.divergence->cause;
      // The first mode of a slender bar. Twenty cells have an error of a thousandth of it, plane stress another
      // one; nodes without mass would hold the bar to a thousandth.
      const double omega = std::numbers::pi / 2, amplitude = 0.1 / omega;
      for (std::size_t i = 0; i < memory.rows.size(); ++i)
        EXPECT_NEAR(memory.rows[i][test::column(model, "tip.displacement.x")],
                    amplitude * std::sin(omega * memory.times[i]), 0.03 * amplitude)
            << shape << shift << i;
      EXPECT_NEAR(memory.rows.back()[test::column(model, "energies.balance_error")], 0, 5e-3);
    }
}

TEST(Surfaces, OfASingleRowOnFacesOfCellsStopATotalLagrangianRunThatTheyWouldHoldFast) {
  // Nodes on either side have no mass.
  const Model model = validate(bar_on_faces("linear", 0.75));
  test::Memory memory;
  const RunResult result = run(model, {}, memory, nullptr);
  ASSERT_EQ(result.end, RunEnd::diverged);
  EXPECT_LE(result.divergence->step, 4);
  EXPECT_THAT(result.divergence->cause, HasSubstr("faces of cells"));
  EXPECT_THAT(result.divergence->remedy, HasSubstr("domain.lower"));
}

TEST(Supports, OfSplinesWithinTheDomainAreWarnedOfBesideOtherThings) {
  const auto warnings = [](double lower, double poissons_ratio) {
    Scene scene = test::bar("TLMPM", "linear_elastic", 0.5, 0.1);
    scene.materials = {test::material("linear_elastic", 100, poissons_ratio, 1)};
    scene.numerics.shape_functions = "quadratic_bspline";
    scene.domain.dimension = Dimension::plane_strain;
    scene.domain.lower.x = lower;
    scene.boundaries[0].nodes = Box{{lower, -2}, {0, 3}};
    scene.analysis.end_time = 0.1;
    const Model model = validate(scene);
    test::Memory memory;
    return run(model, {}, memory, nullptr).warnings;
  };
  // Splines begin anew at a face of the domain, and are held there by its nodes.
  EXPECT_TRUE(warnings(0, 0).empty());
  const std::vector<Warning> soft = warnings(-2, 0.499);
  ASSERT_EQ(soft.size(), 2u);
  EXPECT_EQ(soft[0].name, "locking of \"bar\"");
  EXPECT_EQ(soft[1].name, "soft support by \"left\"");
  EXPECT_THAT(soft[1].cause, HasSubstr("\"left\" holds nodes within the domain"));
  EXPECT_THAT(soft[1].remedy, HasSubstr("hinge"));
}

TEST(Rest, ThatCannotBeFreedOfItsStressIsDivergence) {
  Scene scene = test::discs(0.04);
  scene.domain.dimension = Dimension::plane_stress;
  scene.materials = {test::material("neo_hookean", 1000, 0.3, 1000)};
  // Newton's method takes steps of order one in the logarithm of the stretch across, and too few for this.
  scene.bodies[0].initial_deformation.components = {"1e6"};
  const Model model = validate(scene);
  test::Memory memory;
  const RunResult result = run(model, {}, memory, nullptr);
  ASSERT_EQ(result.end, RunEnd::diverged);
  EXPECT_THAT(result.divergence->cause, HasSubstr("frees a particle of the stress across it"));
  EXPECT_THAT(result.divergence->remedy, HasSubstr("a material that bears such a deformation"));
}

}  // namespace
}  // namespace trajan
