#include <cmath>
#include <numbers>

#include "tests/unit/boundaries/runs.h"

namespace trajan {
namespace {

using test::block;
using test::epsilon;
using test::Histories;

constexpr double gravity = 10;

/// A block on an incline: axes go along it, gravity is turned.
Scene incline(double angle, double friction, const std::string& scheme) {
  Scene scene = block();
  scene.numerics.scheme = scheme;
  scene.boundaries = {{"incline", {}, RigidPlane{{0, 0}, {0, 1}, {friction, false, false, {}}}}};
  scene.loads = {{"gravity", BodyForce{{gravity * std::sin(angle), -gravity * std::cos(angle)}, {}}}};
  scene.analysis.damping = 0;
  return scene;
}

class Incline : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Schemes, Incline, testing::Values("USL", "MUSL", "TLMPM"));

TEST_P(Incline, TakesCoulombsShareOfTheNormalImpulse) {
  const double angle = std::numbers::pi / 6, friction = 0.3;
  Scene scene = incline(angle, friction, GetParam());
  scene.bodies[0].initial_velocity.x = "3";
  const Histories run(scene);
  for (std::size_t row = 1; row < run.rows(); ++row) {
    // All of the foot slides: friction is that share of the normal impulse in every step, whatever the
    // block's vibrations are. Momenta of up to 10 are rounded in every step; where particles cross cells a
    // node of little mass may slide backwards or stick for a moment.
    const double weight = 2 * gravity * run.time(row);
    const double along = weight * std::sin(angle) - (run.at(row, "momentum.x") - 6);
    const double normal = weight * std::cos(angle) + run.at(row, "momentum.y");
    const double share = GetParam() == "TLMPM" ? 0 : GetParam() == "MUSL" ? 2e-3 : 2e-2;
    const double backwards = share * friction * normal;
    EXPECT_NEAR(along, friction * normal, 100 * epsilon * run.steps() + backwards);
  }
  // g (sin a - mu cos a), but for the share of the normal vibration, which is of the size of the time that a wave
  // takes through the block (1/37) over that of the run.
  EXPECT_NEAR(run.last("momentum.x") / 2 - 3, gravity * (std::sin(angle) - friction * std::cos(angle)),
              0.03 * 2.4);
}

TEST_P(Incline, HoldsBelowTheAngleOfFriction) {
  Scene scene = incline(std::atan(0.25), 0.5, GetParam());
  scene.analysis.damping = 10;
  const Histories run(scene);
  // It leans by elasticity alone: shear of g sin a / G in about 1 high block of density 1.
  const double lean = gravity * 0.25 / (1000 / 2.6);
  EXPECT_LT(std::abs(run.last("middle.displacement.x")), lean);
  EXPECT_NEAR(run.last("momentum.x"), 0, 0.02);
}

TEST(RigidPlane, LetsAParticleGoUnlessItHoldsIt) {
  for (const bool held : {false, true}) {
    Scene scene = incline(0, 0, "MUSL");
    std::get<RigidPlane>(scene.boundaries[0].condition).contact.no_separation = held;
    scene.loads.clear();
    scene.bodies[0].initial_velocity = {{}, "1"};
    scene.analysis.end_time = 0.3;
    const Histories run(scene);
    if (held) {
      EXPECT_LT(run.last("middle.displacement.y"), 0.1);
    } else {
      EXPECT_NEAR(run.last("middle.displacement.y"), 0.3, 1e-12);
    }
  }
}

TEST(RigidPlane, DoesNotBiteWhatSlidesOffAcrossIt) {
  Scene scene = incline(0, 0, "MUSL");
  scene.loads.clear();
  scene.bodies[0].initial_velocity = {"1.5", {}};
  const Histories run(scene);
  EXPECT_NEAR(run.last("momentum.x"), 3, 100 * epsilon * run.steps());
  // Crossing cells makes stress, which presses on the plane: its work is noise of that size.
  EXPECT_NEAR(run.last("energies.dissipated"), 0, 2e-3 * run.at(0, "energies.kinetic"));
}

TEST(RigidPlane, WorksOnWhatItPushesAsItsPowerSays) {
  Scene scene = block();
  scene.boundaries = {{"piston", {}, RigidPlane{{0, 0}, {1, 0}, {0, false, false, {"0.5*t^2"}}}}};
  scene.domain.upper.x = 12;
  const Histories run(scene);
  // The plane pushes with its acceleration 1 once waves have settled: all energy is its work less what impacts
  // consume; leapfrog and crossings of cells err by a few per cent of it.
  EXPECT_NEAR(run.last("momentum.x"), 2, 0.1);
  EXPECT_GT(run.last("energies.work"), 0.9);
  EXPECT_NEAR(run.last("energies.balance_error"), 0, 0.05);
}

TEST(RigidBall, CatchesABlockAndAccountsForEveryJoule) {
  Scene scene = block();
  scene.bodies[0].initial_velocity = {{}, "-2"};
  scene.bodies[0].geometry = Box{{0, 0.5}, {2, 1.5}};
  scene.boundaries = {{"ball", {}, RigidBall{{1, -1}, 1.1, {0.5, false, false, {}}}}};
  scene.analysis.end_time = 0.5;
  const Histories run(scene);
  EXPECT_GT(run.last("momentum.y"), -4 + 1);
  // The ball is below the middle; where nodes slide or stick is decided by rounding.
  EXPECT_NEAR(run.last("momentum.x"), 0, 1e-3);
  // What lumped masses lose in an impact is not accounted for.
  EXPECT_NEAR(run.last("energies.balance_error"), 0, 0.15);
}

}  // namespace
}  // namespace trajan
