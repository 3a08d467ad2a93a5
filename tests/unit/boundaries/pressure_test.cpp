#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/unit/boundaries/runs.h"

namespace trajan {
namespace {

using test::block;
using test::epsilon;
using test::Histories;

class PressureOf : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Schemes, PressureOf, testing::Values("USL", "MUSL", "TLMPM"));

/// A block that turns by half under a small pressure on its right edge.
Scene spinning(const std::string& scheme, bool follows, double cell) {
  Scene scene = block(8000);
  scene.numerics.scheme = scheme;
  // Without kinks, which crossing of cells would make felt.
  if (scheme != "TLMPM") scene.numerics.shape_functions = scheme == "USL" ? "cpdi" : "quadratic_bspline";
  scene.domain.lower = {-4, -4};
  scene.domain.cell_size = cell;
  scene.bodies[0].geometry = Box{{-1, -0.5}, {1, 0.5}};
  scene.bodies[0].initial_velocity = {"-y*pi", "x*pi"};
  scene.loads = {{"blow", test::pressure(test::surface("block", Edge::right), 0.5, follows)}};
  scene.outputs.samples = 100;
  scene.outputs.probes = {{"left", Vector{-0.9, 0.1}, {Field::position}, ""},
                          {"right", Vector{0.9, 0.1}, {Field::position}, ""}};
  return scene;
}

/// The largest difference of the momentum from the impulse of a pressure that turns with the block, relative to
/// the whole impulse.
double turning_error(const Histories& turning) {
  const double p = 0.5;
  double impulse_x = 0, impulse_y = 0, last_x = 1, last_y = 0, largest = 0;
  for (std::size_t row = 1; row < turning.rows(); ++row) {
    const double dx = turning.at(row, "right.position.x") - turning.at(row, "left.position.x");
    const double dy = turning.at(row, "right.position.y") - turning.at(row, "left.position.y");
    const double x = dx / std::hypot(dx, dy), y = dy / std::hypot(dx, dy);
    const double interval = turning.time(row) - turning.time(row - 1);
    impulse_x -= p * interval * (x + last_x) / 2;
    impulse_y -= p * interval * (y + last_y) / 2;
    last_x = x, last_y = y;
    largest = std::max(
        largest, std::hypot(turning.at(row, "momentum.x") - impulse_x, turning.at(row, "momentum.y") - impulse_y));
  }
  return largest / p;
}

TEST_P(PressureOf, ASpinningBlockTurnsWithIt) {
  const Histories coarse(spinning(GetParam(), true, 0.25)), fine(spinning(GetParam(), true, 0.125));
  // Gradients at the edge are those of its turning but for an error that is of first order in the cell. What does
  // not go with it, the trapezoidal rule of the impulse, (pi / 100)^2 / 12 = 8e-5, is less.
  EXPECT_LT(turning_error(fine), turning_error(coarse) / 1.8);
  EXPECT_LT(turning_error(coarse), 0.01);
}

TEST_P(PressureOf, ASpinningBlockStaysIfItIsDead) {
  const Histories dead(spinning(GetParam(), false, 0.25));
  for (std::size_t row = 1; row < dead.rows(); ++row) {
    EXPECT_NEAR(dead.at(row, "momentum.x"), -0.5 * dead.time(row), 100 * epsilon * dead.steps());
    EXPECT_NEAR(dead.at(row, "momentum.y"), 0, 100 * epsilon * dead.steps());
  }
}

TEST(Pressure, AllAroundADiscHasNoResultant) {
  Scene scene = block();
  const Disc disc{{1, 1}, 1};
  scene.bodies[0].geometry = disc;
  scene.loads = {{"deep", test::pressure(test::surface("block", disc), 10)}};
  scene.analysis = {2, 100};
  scene.outputs.probes = {{"stress", Region{Disc{{1, 1}, 0.5}}, {Field::stress}, ""}};
  const Histories run(scene);
  // Each piece of the rim turns by itself, so that all of them do not close quite: 1e-3 of the pressure times
  // the diameter is balanced by damping.
  EXPECT_NEAR(run.last("momentum.x"), 0, 1e-3 * 20 / 100);
  // The mean stress in the middle. Particles near a round rim fill it but for half a spacing, a sixteenth.
  EXPECT_NEAR(run.last("stress.stress.xx"), -10, 0.6);
  EXPECT_NEAR(run.last("stress.stress.yy"), -10, 0.6);
}

// Carriers of a sphere's 45 000 points are found among the rows next to them, not among all 3600.
TEST(Pressure, MayActOnALargeBall) {
  Scene scene = block();
  scene.domain = {Dimension::solid, {-4, -4, -4}, {4, 4, 4}, 0.25, {}};
  const Sphere ball{{0, 0, 0}, 3.75};
  scene.bodies[0].geometry = ball;
  scene.loads = {{"deep", test::pressure(test::surface("block", Disc{ball.centre, ball.radius}), 10)}};
  scene.outputs.probes = {};
  const Model model = validate(scene);
  double area = 0;
  for (const LoadPoint& point : model.surface_loads.at(0).points) area += point.area;
  EXPECT_NEAR(area, 4 * std::numbers::pi * 3.75 * 3.75, 1e-9 * area);
}

TEST(Pressure, OnAnEdgeIsTheStressBehindIt) {
  Scene scene = block();
  scene.materials = {test::material("linear_elastic", 1000, 0, 1)};
  scene.bodies[0].geometry = Box{{0, 0}, {2, 1}};
  scene.boundaries = {{"wall", Box{{0, -2}, {0, 6}}, Fixed{{Axis::x}}}};
  scene.loads = {{"push", test::pressure(test::surface("block", Edge::right), 1)}};
  scene.analysis = {2, 30};
  scene.outputs.probes = {{"stress", Region{Box{{0, 0}, {1, 1}}}, {Field::stress}, ""}};
  const Histories run(scene);
  // Static to exp(-10), with strains of 1e-3 as the other error.
  EXPECT_NEAR(run.last("stress.stress.xx"), -1, 2e-3);
}

TEST(Traction, OnlyLoadsThePartWithinItsRegion) {
  Scene scene = block();
  scene.loads = {{"push", EdgeTraction{"block", Edge::right, {-3, 1}, "", Box{{0, 0.5}, {5, 6}}}}};
  const Histories run(scene);
  EXPECT_NEAR(run.last("momentum.x"), -1.5, 100 * epsilon * run.steps());
  EXPECT_NEAR(run.last("momentum.y"), 0.5, 100 * epsilon * run.steps());
}

}  // namespace
}  // namespace trajan
