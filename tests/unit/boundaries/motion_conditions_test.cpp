#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "solver/boundaries/prescribed_nodes.h"
#include "tests/unit/boundaries/runs.h"

namespace trajan {
namespace {

using test::block;
using test::epsilon;
using test::Histories;

class MotionConditions : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Schemes, MotionConditions, testing::Values("USL", "MUSL", "TLMPM"));

TEST_P(MotionConditions, PrescribedDisplacementsAreExactAtSamples) {
  Scene scene = block();
  scene.numerics.scheme = GetParam();
  scene.bodies[0].initial_velocity.x = "1.5";
  scene.boundaries = {{"all", Box{{-4, -2}, {12, 6}}, PrescribedDisplacement{{"0.3*sin(5*t)", "0.2*t^2"}}}};
  const Histories run(scene);
  // Particles are moved by roundings of 2 in each step.
  const double rounding = 4 * epsilon * run.steps();
  for (std::size_t row = 0; row < run.rows(); ++row) {
    const double t = run.time(row);
    EXPECT_NEAR(run.at(row, "middle.displacement.x"), 0.3 * std::sin(5 * t), rounding);
    EXPECT_NEAR(run.at(row, "middle.displacement.y"), 0.2 * t * t, rounding);
    // The rate of the displacement over 1e-6 of the time between samples, rounded.
    EXPECT_NEAR(run.at(row, "middle.velocity.x"), 1.5 * std::cos(5 * t), 1e-6);
  }
}

TEST_P(MotionConditions, VelocitiesThatDependOnPlaceStretchTheBodyEvenly) {
  Scene scene = block();
  scene.numerics.scheme = GetParam();
  scene.boundaries = {{"all", Box{{-4, -2}, {12, 6}}, PrescribedVelocity{{"0.1*(x-1)", "-0.1*(y-0.5)"}}}};
  scene.outputs.probes = {{"corner", Vector{2, 1}, {Field::displacement}, ""}};
  const Histories run(scene);
  // The particle next to the corner. In updated Lagrangian schemes dx/dt = v(x), the midpoint of forward Euler
  // steps, in the total Lagrangian one v is of the reference position.
  const bool total = GetParam() == "TLMPM";
  const double x = 0.9375, y = 0.4375;
  const double grown = total ? 0.1 : std::expm1(0.1), shrunk = total ? -0.1 : std::expm1(-0.1);
  // Forward Euler errs by half a step times the rate squared.
  const double euler = 0.5 * 0.01 / run.steps();
  EXPECT_NEAR(run.last("corner.displacement.x"), grown * x, total ? 1e-13 : 1.2 * euler);
  EXPECT_NEAR(run.last("corner.displacement.y"), shrunk * y, total ? 1e-13 : 1.2 * euler);
}

TEST_P(MotionConditions, SymmetryMakesOfHalfABlockTheWhole) {
  Scene whole = block(100);
  whole.numerics.scheme = GetParam();
  whole.domain.lower = {-4, -2};
  whole.bodies[0].geometry = Box{{-2, 0}, {2, 1}};
  whole.bodies[0].initial_velocity = {"0.1*x", "0.1*y"};
  whole.outputs.probes = {{"tip", Vector{1.9, 0.9}, {Field::displacement}, ""}};
  Scene half = whole;
  half.domain.lower.x = 0;
  half.bodies[0].geometry = Box{{0, 0}, {2, 1}};
  half.boundaries = {{"mirror", {}, Symmetry{Edge::left}}};
  Scene roller = half;
  roller.boundaries = {{"wall", Edge::left, Roller{}}};
  const Histories a(whole), b(half), c(roller);
  for (std::size_t row = 0; row < a.rows(); ++row) {
    // Sums in another order, and what elasticity makes of their rounding in as many steps.
    const double rounding = 100 * epsilon * a.steps();
    EXPECT_NEAR(a.at(row, "tip.displacement.x"), b.at(row, "tip.displacement.x"), rounding);
    EXPECT_NEAR(a.at(row, "tip.displacement.y"), b.at(row, "tip.displacement.y"), rounding);
    EXPECT_EQ(b.at(row, "tip.displacement.y"), c.at(row, "tip.displacement.y"));
  }
}

/// The largest difference of a probe in half a block from the same in the whole.
double mirror_error(const std::string& shape, double cell) {
  Scene whole = block(100);
  whole.numerics.shape_functions = shape;
  if (shape == "bernstein") whole.numerics.scheme = "TLMPM";
  whole.numerics.time_step = 0.02 * cell;
  whole.domain.lower = {-4, -2};
  whole.domain.upper = {4, 6};
  whole.domain.cell_size = cell;
  whole.bodies[0].geometry = Box{{-2, 0}, {2, 1}};
  whole.bodies[0].initial_velocity = {"0.1*sin(x)", "0.1*(y-0.5)*cos(x)"};
  const Region near = Box{{0, 0}, {0.5, 1}};
  whole.outputs.probes = {{"near", near, {Field::displacement, Field::stress}, ""}};
  Scene half = whole;
  half.domain.lower.x = 0;
  half.bodies[0].geometry = Box{{0, 0}, {2, 1}};
  half.boundaries = {{"mirror", {}, Symmetry{Edge::left}}};
  const Histories a(whole), b(half);
  double largest = 0;
  for (std::size_t row = 0; row < a.rows(); ++row)
    for (const char* column : {"near.displacement.x", "near.stress.xx"})
      largest = std::max(largest, std::abs(a.at(row, column) - b.at(row, column)) * (column[5] == 's' ? 0.01 : 1));
  return largest;
}

TEST(Symmetry, OfFunctionsThatEndAtTheFaceIsThatOfTheWhole) {
  // Displacements of some 0.03 and rounding of a hundred steps.
  for (const char* shape : {"linear", "bernstein"}) EXPECT_LT(mirror_error(shape, 0.25), 1000 * epsilon) << shape;
}

TEST(Symmetry, OfFunctionsThatReachBeyondTheFaceConvergesToTheWhole) {
  // At a face B-splines become others, which interpolate there; both are of second order.
  for (const char* shape : {"quadratic_bspline", "cubic_bspline"})
    EXPECT_GT(std::log2(mirror_error(shape, 0.25) / mirror_error(shape, 0.125)), 2) << shape;
}

TEST(Formulas, ThatFailDuringTheRunStopItWithTheirField) {
  // Finite at the 257 times that are looked at before the run, 1/256 apart.
  const std::string gap = "t > 0.0082 && t < 0.0115 ? sqrt(-1) : 0.1";
  Scene scene = block();
  scene.boundaries = {{"all", Box{{-4, -2}, {12, 6}}, PrescribedVelocity{{gap, {}}}}};
  scene.numerics.time_step = 1e-3;
  test::Memory memory;
  const Model moved = validate(scene);
  const RunResult result = run(moved, {}, memory, nullptr);
  ASSERT_EQ(result.end, RunEnd::diverged);
  EXPECT_THAT(result.divergence->cause,
              testing::HasSubstr("boundaries[0].prescribed_velocity.velocity.x is not a number at t = 0.0085"));
  scene.boundaries.clear();
  scene.loads = {{"gravity", BodyForce{{0, -1}, {}}, gap}};
  const Model loaded = validate(scene);
  const RunResult second = run(loaded, {}, memory, nullptr);
  ASSERT_EQ(second.end, RunEnd::diverged);
  EXPECT_THAT(second.divergence->cause,
              testing::HasSubstr("loads[0].time.expression is not a number at t = 0.009"));
}

TEST(PrescribedNodes, LaterConditionsWinComponentByComponent) {
  Scene scene = block();
  scene.boundaries = {{"first", Box{{0, 0}, {1, 1}}, PrescribedVelocity{{"1", "2"}}},
                      {"second", Box{{1, 0}, {2, 1}}, PrescribedVelocity{{"3", {}}}}};
  const Model model = validate(scene);
  PrescribedNodes condition(model);
  // The tile of nodes (16 .. 23, 8 .. 15), at x = 0 .. 1.75 and y = 0 .. 1.75.
  std::vector<double> values(7 * TileNodes::count, 0.0);
  std::fill_n(values.begin(), TileNodes::count, 1.0);
  const TileNodes tile{2, {16, 8, 0}, values.data()};
  HeldComponents held(TileNodes::count, 0);
  condition.bind({&tile, 1}, held);
  condition.prepare({0, 0, 0.1, 0.1});
  std::vector<Reaction> reactions(model.conditions.size());
  condition.act(0, tile, reactions);
  EXPECT_EQ(tile.velocity(0)[3], 1);
  EXPECT_EQ(tile.velocity(0)[4], 3) << "at x = 1 both act";
  EXPECT_EQ(tile.velocity(1)[4], 2) << "the second leaves y alone";
  EXPECT_EQ(tile.velocity(0)[5], 3);
  EXPECT_EQ(tile.velocity(1)[5], 0);
  EXPECT_EQ(held[4], 3);
  EXPECT_EQ(held[5], 1);
  EXPECT_EQ(held[5 * 8], 0) << "at y = 1.25 none acts";
}

}  // namespace
}  // namespace trajan
