#include <cmath>

#include "solver/simulation/simulation.h"
#include "tests/unit/boundaries/runs.h"

namespace trajan {
namespace {

using test::block;
using test::epsilon;
using test::Histories;

TEST(Reactions, CarryTheWeightOfWhatRestsOnThem) {
  Scene scene = block();
  scene.boundaries = {{"floor", Box{{-4, 0}, {12, 0}}, Fixed{{Axis::y}}}, {"aside", Box{{0, 5}, {1, 6}}, Fixed{}}};
  scene.loads = {{"gravity", BodyForce{{0, -10}, {}}, Ramp{0, 1, true}}};
  scene.analysis = {4, 40};
  scene.outputs.reactions = {"aside", "floor"};
  const Histories run(scene);
  // Mass 2; the lowest oscillation, of a rate of 58, has decayed by exp(-20 * 3). Particles keep a little momentum
  // that maps to the held nodes alone, and damping acts on it.
  EXPECT_NEAR(run.last("reactions.floor.y"), 20 + 40 * run.last("momentum.y"), 1e-9);
  EXPECT_NEAR(run.last("reactions.floor.y"), 20, 1e-4);
  EXPECT_EQ(run.at(0, "reactions.floor.y"), 0);
  for (std::size_t row = 0; row < run.rows(); ++row) {
    EXPECT_EQ(run.at(row, "reactions.floor.x"), 0);
    EXPECT_EQ(run.at(row, "reactions.aside.y"), 0) << "where there is no material";
  }
}

TEST(Reactions, OfSeveralConditionsAreThoseOfTheNodesThatEachHolds) {
  Scene scene = block();
  scene.bodies[0].initial_velocity = {"-0.3*x", {}};
  scene.boundaries = {{"all", Box{{0, -2}, {0, 6}}, Fixed{}},
                      {"upper", Box{{0, 0.5}, {0, 6}}, PrescribedVelocity{{"0.1*t", {}}}},
                      {"hook", {}, test::hinge(test::surface("block", Edge::right), HingeKind::mean)}};
  scene.outputs.reactions = {"all", "upper", "hook"};
  const Histories run(scene);
  double momentum_x = run.at(0, "momentum.x"), momentum_y = 0;
  for (std::size_t row = 1; row < run.rows(); ++row) {
    const double interval = run.time(row) - run.time(row - 1);
    for (const char* name : {"all", "upper", "hook"}) {
      momentum_x += interval * run.at(row, std::string("reactions.") + name + ".x");
      momentum_y += interval * run.at(row, std::string("reactions.") + name + ".y");
    }
    EXPECT_EQ(run.at(row, "reactions.upper.y"), 0);
    EXPECT_NE(run.at(row, "reactions.all.y"), 0);
    EXPECT_NE(run.at(row, "reactions.upper.x"), 0);
    // Stresses of up to 10 are rounded in every step.
    EXPECT_NEAR(run.at(row, "momentum.x"), momentum_x, 16 * epsilon * run.steps());
    EXPECT_NEAR(run.at(row, "momentum.y"), momentum_y, 16 * epsilon * run.steps());
  }
}

TEST(Reactions, AreTheSameFromACheckpointOn) {
  Scene scene = block();
  scene.boundaries = {{"floor", Box{{-4, 0}, {12, 0}}, Fixed{}}};
  scene.bodies[0].initial_velocity.y = "-0.1*y";
  scene.outputs.reactions = {"floor"};
  const Model model = validate(scene);
  test::Memory whole, rest;
  ASSERT_EQ(run(model, {2, 0, {}}, whole, nullptr).end, RunEnd::finished);
  const Checkpoint& checkpoint = whole.checkpoints.at(7);
  Simulation again(model, 1, checkpoint);
  EXPECT_EQ(again.columns(), whole.rows.at(static_cast<std::size_t>(checkpoint.sample)));
  ASSERT_EQ(run(model, {1, 1e9, checkpoint}, rest, nullptr).end, RunEnd::finished);
  for (auto row = static_cast<std::size_t>(checkpoint.sample) + 1; row < whole.rows.size(); ++row)
    EXPECT_EQ(rest.rows.at(row), whole.rows[row]) << row;
}

}  // namespace
}  // namespace trajan
