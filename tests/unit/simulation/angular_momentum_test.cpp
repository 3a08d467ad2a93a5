#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/simulation/scenes.h"

/// What spins must go on spinning where nothing outside stops it.
namespace trajan {
namespace {

/// A block of four cells falls and turns by a tenth of a turn.
Scene spinning(const std::string& scheme, const std::string& shape, const std::string& transfer) {
  Scene scene;
  scene.name = "spinning";
  scene.domain = {Dimension::plane_strain, {-2, -2}, {2, 2}, 0.25, 1};
  scene.materials = {test::material("neo_hookean", 100, 0.3, 1)};
  scene.bodies = {{"block", "solid", Box{{-0.5, -0.5}, {0.5, 0.5}}, 2, {"-y", "x"}}};
  scene.loads = {{"weight", BodyForce{{0, -1}, {}}, {}}};
  scene.analysis = {0.2 * M_PI, 0};
  scene.numerics.scheme = scheme;
  scene.numerics.shape_functions = shape;
  scene.numerics.transfer = transfer;
  scene.outputs.samples = 100;
  scene.outputs.snapshots = 100;
  return scene;
}

/// About the centre of mass, of particles of mass 1.
double spin(const Snapshot& snapshot) {
  double x = 0, y = 0, u = 0, v = 0, sum = 0;
  const std::size_t particles = snapshot.position.size() / 2;
  for (std::size_t p = 0; p < particles; ++p) {
    x += snapshot.position[2 * p], y += snapshot.position[2 * p + 1];
    u += snapshot.velocity[2 * p], v += snapshot.velocity[2 * p + 1];
    sum += snapshot.position[2 * p] * snapshot.velocity[2 * p + 1];
    sum -= snapshot.position[2 * p + 1] * snapshot.velocity[2 * p];
  }
  return sum - (x * v - y * u) / static_cast<double>(particles);
}

TEST(AngularMomentum, IsWatchedWhereLumpedMassesLoseIt) {
  const Model model = validate(spinning("MUSL", "gimp", "FLIP"));
  test::Memory memory;
  const RunResult result = run(model, {1, 0, {}}, memory, nullptr);
  ASSERT_EQ(result.warnings.size(), 1u);
  const Warning& warning = result.warnings[0];
  EXPECT_EQ(warning.name, "angular momentum");
  EXPECT_NE(warning.remedy.find("APIC"), std::string::npos) << warning.remedy;
  // A rigid spin has all the angular momentum that its energy can have, so that the share told is that of the
  // spin: strains and weight have little of the energy by then.
  const auto row = static_cast<std::size_t>(std::lround(100 * warning.time / model.end_time));
  const double lost = 1 - spin(memory.snapshots[row]) / spin(memory.snapshots[0]);
  EXPECT_GT(lost, 0.03);
  const std::string by = "changed by ";
  const double told = std::stod(warning.cause.substr(warning.cause.find(by) + by.size()));
  EXPECT_NEAR(told / lost, 1, 0.01) << warning.cause;
  // A run that goes on from a checkpoint knows what it began with. There is one of each sample between the first
  // and the last.
  ASSERT_GT(row, 1u);
  test::Memory again;
  const RunResult rest = run(model, {1, 1e9, memory.checkpoints[row - 2]}, again, nullptr);
  ASSERT_EQ(rest.warnings.size(), 1u);
  EXPECT_EQ(rest.warnings[0].cause, warning.cause);
}

TEST(AngularMomentum, IsKeptByAffineTransfersAndNotAskedOfWhatIsHeld) {
  Scene held = spinning("MUSL", "gimp", "FLIP");
  held.boundaries = {{"pivot", Box{{0, 0}, {0, 0}}, Fixed{{Axis::x, Axis::y}}}};
  Scene apart = spinning("MUSL", "gimp", "FLIP");
  // Far from the origin, where squares of places have lost half of their digits, bodies pass by each other.
  const double far = 1e6;
  apart.domain = {Dimension::plane_strain, {far, far}, {far + 8, far + 4}, 0.25, 1};
  apart.bodies = {{"one", "solid", Box{{far + 1, far + 1}, {far + 2, far + 2}}, 2, {"3", "1"}},
                  {"two", "solid", Box{{far + 5, far + 3}, {far + 6, far + 3.5}}, 2, {"-3", {}}}};
  for (const Scene& scene : {spinning("MUSL", "gimp", "APIC"), held, apart}) {
    test::Memory memory;
    const RunResult result = run(validate(scene), {}, memory, nullptr);
    EXPECT_EQ(result.end, RunEnd::finished);
    EXPECT_TRUE(result.warnings.empty()) << result.warnings[0].cause;
  }
}

}  // namespace
}  // namespace trajan
