#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/schemes/scheme.h"
#include "solver/simulation/simulation.h"
#include "solver/transfers/transfer.h"
#include "tests/unit/simulation/scenes.h"

/// Bodies with velocity fields of their own.
namespace trajan {
namespace {

using test::column;
using test::recorded;

using std::numbers::pi;

/// Two elastic blocks in a plane, whose faces are a gap apart along x; the left one moves.
Scene blocks(const std::string& shapes, double gap, VectorExpression velocity) {
  Scene scene;
  scene.name = "blocks";
  scene.domain = {Dimension::plane_strain, {0, 0}, {8, 4}, 0.25, 1};
  scene.materials = {test::material("neo_hookean", 1000, 0.3, 1)};
  scene.bodies = {{"left", "solid", Box{{1, 1}, {3, 3}}, 2, velocity},
                  {"right", "solid", Box{{3 + gap, 1.1}, {4 + gap, 2.9}}, 2, {}}};
  scene.numerics.shape_functions = shapes;
  scene.outputs.samples = 10;
  scene.outputs.snapshots = 10;
  scene.contacts = {{}};
  return scene;
}

class ContactWithShapes : public testing::TestWithParam<std::string> {};

TEST_P(ContactWithShapes, BodiesFeelNothingBeforeTheyTouch) {
  const double gap = 0.125, speed = 1;  // half a cell
  Scene scene = blocks(GetParam(), gap, {"1", "0.5"});
  // Until a hundredth of a cell is left.
  scene.analysis.end_time = 0.98 * gap / speed;
  const Model model = validate(scene);
  const test::Memory memory = recorded(model);
  // A block in free flight, as it left.
  const double kinetic = 0.5 * 4 * (1 + 0.25);
  EXPECT_NEAR(memory.rows.back()[column(model, "energies.kinetic")], kinetic, 1e-12 * kinetic);
  EXPECT_NEAR(memory.rows.back()[column(model, "energies.strain")], 0, 1e-12 * kinetic);
  EXPECT_EQ(memory.rows.back()[column(model, "energies.dissipated")], 0);
}

TEST_P(ContactWithShapes, BodiesTouchWhenTheirFacesMeet) {
  const double gap = 0.125, speed = 1;
  Scene scene = blocks(GetParam(), gap, {"1", {}});
  // Some steps later: of about 0.002 each.
  scene.analysis.end_time = gap / speed + 0.02;
  const Model model = validate(scene);
  const test::Memory memory = recorded(model);
  EXPECT_GT(memory.rows.back()[column(model, "energies.strain")], 1e-3);
}

/// Products of several functions that are wide.
INSTANTIATE_TEST_SUITE_P(Contact, ContactWithShapes,
                         testing::Values("linear", "gimp", "cpgimp", "quadratic_bspline", "cubic_bspline", "cpdi"),
                         [](const auto& tested) { return tested.param; });

TEST(ContactBetweenBodies, ImpulsesAreEqualAndOpposite) {
  Scene scene = blocks("quadratic_bspline", 0, {"1", "0.5"});
  scene.contacts[0].friction = 0.2;
  scene.analysis.end_time = 0.2;
  const Model model = validate(scene);
  const test::Memory memory = recorded(model);
  for (const char* momentum : {"momentum.x", "momentum.y"}) {
    const std::size_t c = column(model, momentum);
    // A few roundings for each of some hundred steps.
    EXPECT_NEAR(memory.rows.back()[c], memory.rows.front()[c], 1e-13 * 4);
  }
}

TEST(ContactBetweenBodies, ResultDoesNotDependOnThreadsOrInterruption) {
  Scene scene = blocks("linear", 0.01, {"1", "0.5"});
  scene.contacts[0].friction = 0.2;
  scene.outputs.reactions = {"left"};
  scene.analysis.end_time = 0.06;
  const Model model = validate(scene);
  Simulation one(model, 1), two(model, 2);
  while (one.sample() < 5) one.step();
  const Checkpoint checkpoint = one.save();
  Simulation resumed(model, 2, checkpoint);
  EXPECT_EQ(one.columns(), resumed.columns());
  while (one.sample() < 10) one.step();
  while (two.sample() < 10) two.step();
  while (resumed.sample() < 10) resumed.step();
  EXPECT_EQ(one.columns(), two.columns());
  EXPECT_EQ(one.columns(), resumed.columns());
  EXPECT_GT(one.executor().account().exchanged().dissipated, 0);
}

/// Two bars of unit length, stiffness and density in one dimension, the left one with a small velocity.
TEST(ContactBetweenBodies, BarsExchangeTheirVelocitiesWhileAWaveGoesToAndFro) {
  const double speed = 0.001, gap = 0.0001, cell = 0.02;
  Scene scene;
  scene.name = "bars";
  scene.domain = {Dimension::bar, {-1, 0}, {3, 0}, cell, {}, 1};
  scene.materials = {test::material("linear_elastic", 1, 0, 1)};
  scene.bodies = {{"left", "solid", Box{{-gap, 0}, {1 - gap, 0}}, 2, {"0.001", {}}},
                  {"right", "solid", Box{{1, 0}, {2, 0}}, 2, {}}};
  scene.numerics.shape_functions = "quadratic_bspline";
  scene.analysis = {3, 0};
  scene.outputs.samples = 300;
  scene.outputs.snapshots = 1;
  scene.outputs.probes = {{"right", Region{Box{{1, 0}, {2, 0}}}, {Field::velocity}, "right"}};
  scene.contacts = {{}};
  const Model model = validate(scene);
  const test::Memory memory = recorded(model);
  // The force between them is constant from the impact at gap / speed until both waves are back 2 later: the mean
  // velocity of the right bar grows linearly. Fronts are a cell or two wide, and nodes lose a cell's share.
  const double start = gap / speed;
  for (std::size_t i = 0; i < memory.rows.size(); ++i) {
    const double exact = speed * std::clamp((memory.times[i] - start) / 2, 0.0, 1.0);
    EXPECT_NEAR(memory.rows[i][column(model, "right.velocity.x")], exact, 1.5 * cell * speed) << memory.times[i];
  }
}

/// A block of 2 x 1 at rest on a base that is 1 high, both elastic, under a gravity of 1 that is inclined.
Scene slope(double angle, double friction) {
  Scene scene;
  scene.name = "slope";
  scene.constants = {{"sine", std::to_string(std::sin(angle))}, {"cosine", std::to_string(std::cos(angle))}};
  scene.domain = {Dimension::plane_strain, {0, 0}, {10, 4}, 0.25, 1};
  scene.materials = {test::material("linear_elastic", 2000, 0.3, 1)};
  scene.bodies = {{"base", "solid", Box{{0.5, 0}, {9.5, 1}}, 2, {}},
                  {"block", "solid", Box{{1.5, 1}, {3.5, 2}}, 2, {}}};
  scene.boundaries = {{"ground", Box{{0, 0}, {10, 0}}, Fixed{}}};
  scene.loads = {{"gravity", BodyForce{{std::sin(angle), -std::cos(angle)}, {"block"}}, 1.0}};
  scene.numerics.shape_functions = "quadratic_bspline";
  scene.analysis = {2, 0};
  scene.outputs.samples = 20;
  scene.outputs.snapshots = 1;
  scene.outputs.probes = {
      {"block", Region{Box{{1.5, 1}, {3.5, 2}}}, {Field::displacement, Field::velocity}, "block"}};
  scene.contacts = {{{}, friction}};
  return scene;
}

TEST(ContactBetweenBodies, ABlockSlidesDownASlopeAsCoulombSays) {
  const double angle = pi / 6, friction = 0.3;
  Scene scene = slope(angle, friction);
  // Without the bouncing of a sudden start, which keeps energy. The integral over time of the share of gravity is
  // 0.5 at the end of the ramp and 1.5 at the end, and the integral of that as below.
  scene.loads[0].time = Ramp{0, 1, true};
  const Model model = validate(scene);
  const test::Memory memory = recorded(model);
  const auto last = [&](const char* name) { return memory.rows.back()[column(model, name)]; };
  const double acceleration = std::sin(angle) - friction * std::cos(angle);
  const double way = acceleration * (0.25 - 1 / (pi * pi) + 1);
  // The block's foot is a cell or two behind its middle, by sag and shear: weight over stiffness, 2 / 2000.
  EXPECT_NEAR(last("block.displacement.x"), way, 0.002);
  // Friction, which grows with gravity, times speed.
  const double force = 2 * friction * std::cos(angle);
  EXPECT_NEAR(last("energies.contact"), force * acceleration * 0.5 * 1.5 * 1.5, 0.002 * force);
  EXPECT_EQ(last("energies.contact"), last("energies.dissipated"));
  EXPECT_NEAR(last("energies.balance_error"), 0, 0.002);
}

TEST(ContactBetweenBodies, ABlockStaysOnASlopeThatIsNotSteepEnough) {
  Scene scene = slope(pi / 6, 0.7);
  // Without the bouncing of a sudden start, during which friction has little to hold it by.
  scene.loads[0].time = Ramp{0, 1, true};
  const Model model = validate(scene);
  const test::Memory memory = recorded(model);
  const auto last = [&](const char* name) { return memory.rows.back()[column(model, name)]; };
  // What slides freely comes as far as 0.5 in the second after the ramp.
  EXPECT_NEAR(last("block.displacement.x"), 0, 0.01);
  EXPECT_NEAR(last("block.velocity.x"), 0, 0.01);
}

TEST(ContactBetweenBodies, ForcesAreWhatChangesTheMomentumOfABody) {
  Scene scene = slope(pi / 6, 0.3);
  scene.outputs.reactions = {"block", "base"};
  const Model model = validate(scene);
  const test::Memory memory = recorded(model);
  const double mass = 2, gravity[] = {std::sin(pi / 6), -std::cos(pi / 6)};
  for (std::size_t row = 1; row < memory.rows.size(); ++row)
    for (int axis = 0; axis < 2; ++axis) {
      const std::string name = std::string(".") + "xy"[axis];
      const auto at = [&](std::size_t r, const std::string& of) {
        return memory.rows[r][column(model, of + name)];
      };
      const double interval = memory.times[row] - memory.times[row - 1];
      const double change = mass * (at(row, "block.velocity") - at(row - 1, "block.velocity"));
      // Forces of about 1 are added up over some hundred steps.
      EXPECT_NEAR(at(row, "reactions.block") + mass * gravity[axis], change / interval, 1e-11);
      EXPECT_NEAR(at(row, "reactions.block") + at(row, "reactions.base"), 0, 1e-12);
    }
}

/// Momentum of one body, and its angular momentum about its centre of mass and about the origin.
struct Motion {
  Vector momentum, centre;
  double mass = 0, spin = 0, angular_momentum = 0;
};

Motion motion_of(const Model& model, const Snapshot& snapshot, std::size_t index) {
  const Body& body = model.bodies[index];
  const double mass = model.materials[body.material].density * body.particle_volume;
  Motion motion;
  for (std::int64_t p = body.first_particle; p < body.first_particle + body.particles; ++p) {
    const double* x = &snapshot.position[static_cast<std::size_t>(2 * p)];
    const double* v = &snapshot.velocity[static_cast<std::size_t>(2 * p)];
    motion.mass += mass;
    motion.centre.x += mass * x[0];
    motion.centre.y += mass * x[1];
    motion.momentum.x += mass * v[0];
    motion.momentum.y += mass * v[1];
    motion.angular_momentum += mass * (x[0] * v[1] - x[1] * v[0]);
  }
  motion.centre.x /= motion.mass;
  motion.centre.y /= motion.mass;
  motion.spin =
      motion.angular_momentum - (motion.centre.x * motion.momentum.y - motion.centre.y * motion.momentum.x);
  return motion;
}

/// Two discs of radius 1 that graze each other.
Scene grazing_discs(const std::string& transfer, double friction) {
  Scene scene;
  scene.name = "grazing_discs";
  scene.domain = {Dimension::plane_strain, {-4, -4}, {4, 4}, 0.0625, 1};
  scene.materials = {test::material("neo_hookean", 1000, 0.3, 1)};
  scene.bodies = {{"left", "solid", Disc{{-1.01, 0}, 1}, 2, {"0.1", "0.2"}},
                  {"right", "solid", Disc{{1.01, 0}, 1}, 2, {"-0.1", "-0.2"}}};
  scene.numerics.shape_functions = "quadratic_bspline";
  scene.numerics.transfer = transfer;
  scene.analysis.end_time = 0.6;
  scene.outputs.samples = 12;
  scene.outputs.snapshots = 12;
  scene.contacts = {{{}, friction}};
  return scene;
}

TEST(ContactBetweenBodies, DiscsThatGrazeEachOtherGetTheSpinThatFrictionGives) {
  const double friction = 0.2;
  const Model model = validate(grazing_discs("FLIP", friction));
  const test::Memory memory = recorded(model);
  const Motion before = motion_of(model, memory.snapshots.front(), 0),
               after = motion_of(model, memory.snapshots.back(), 0);
  const Motion other = motion_of(model, memory.snapshots.back(), 1);
  const double impulse = std::hypot(after.momentum.x - before.momentum.x, after.momentum.y - before.momentum.y);
  // The lever of the tangential impulse is the radius.
  const double tangential = std::abs(after.spin), normal = std::sqrt(impulse * impulse - tangential * tangential);
  // Normals of discs that are made of cuboids are 2.6 degrees off (root of the mean square), of which the mean
  // over some six nodes of the contact leaves one.
  EXPECT_NEAR(tangential / normal, friction, pi / 180);
  // Equal discs, and velocities that turn with them but for the grid's error.
  EXPECT_NEAR(other.spin, after.spin, 0.01 * tangential);
  EXPECT_NEAR(after.angular_momentum + other.angular_momentum, 2 * before.angular_momentum, 0.01 * tangential);
  // Contact accounts for what it consumes; FLIP loses some thousandths of the energy that passes through strain.
  EXPECT_NEAR(memory.rows.back()[column(model, "energies.balance_error")], 0, 0.003);
}

}  // namespace
}  // namespace trajan
