#include <cmath>
#include <numbers>

#include "tests/unit/boundaries/runs.h"

namespace trajan {
namespace {

using test::block;
using test::epsilon;
using test::Histories;

/// Schemes, and how far into a cell the left edge lies.
class Hinges : public testing::TestWithParam<std::tuple<std::string, double>> {
 protected:
  std::string scheme() const { return std::get<0>(GetParam()); }
  double offset() const { return std::get<1>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Places, Hinges,
                         testing::Combine(testing::Values("USL", "MUSL", "TLMPM"),
                                          testing::Values(0.0, 0.05, 0.125, 0.2)));

/// A bar of 10 x 1 whose left edge is held.
Scene held_bar(const std::string& scheme, double offset, double velocity) {
  Scene scene = test::bar(scheme, "linear_elastic", 0.25, 0);
  scene.bodies[0].geometry = Box{{offset, 0}, {10 + offset, 1}};
  scene.bodies[0].initial_velocity.x = std::to_string(velocity) + "*sin(pi*(x-" + std::to_string(offset) + ")/20)";
  scene.boundaries = {{"left", {}, test::hinge(test::surface("bar", Edge::left), HingeKind::whole, {Axis::x})}};
  scene.outputs.probes = {{"middle", Vector{5 + offset, 0.5}, {Field::displacement}, ""}};
  return scene;
}

TEST_P(Hinges, HoldAWholeEdgeWhereverItIs) {
  const Scene scene = held_bar(scheme(), offset(), 0.01);
  const Histories run(scene);
  const double omega = std::numbers::pi / 20 * 10, amplitude = 0.01 / omega;
  // The particle nearest to the middle of the bar is half a spacing to its left.
  const double x = 5 - 0.0625;
  for (std::size_t row = 0; row < run.rows(); ++row) {
    const double exact = amplitude * std::sin(std::numbers::pi * x / 20) * std::sin(omega * run.time(row));
    // Particles fill the cell that the edge cuts but for half a spacing, and the bar seems as much longer or
    // shorter: 1/16 of 10, which is as much of the phase of one period.
    EXPECT_NEAR(run.at(row, "middle.displacement.x"), exact, 2 * std::numbers::pi / 160 * amplitude);
  }
}

TEST_P(Hinges, DoTheWorkOfTheirDisplacement) {
  Scene scene = held_bar(scheme(), offset(), 0);
  std::get<Hinge>(scene.boundaries[0].condition).displacement.x = "0.05*t^2";
  const Histories run(scene);
  EXPECT_GT(run.last("energies.work"), 0.01);
  // Leapfrog's error and the grid's own dissipation, some per cent at this resolution (most by USL).
  EXPECT_NEAR(run.last("energies.balance_error"), 0, 0.06);
}

TEST_P(Hinges, HoldTheMeanOfAnEdgeAgainstAWeight) {
  Scene scene = block();
  scene.numerics.scheme = scheme();
  scene.bodies[0].geometry = Box{{offset(), offset()}, {2 + offset(), 1 + offset()}};
  scene.boundaries = {{"hook", {}, test::hinge(test::surface("block", Edge::top), HingeKind::mean)}};
  scene.loads = {{"gravity", BodyForce{{0, -10}, {}}, Ramp{0, 1, true}}};
  scene.analysis = {4, 20};
  scene.outputs.probes = {
      {"top", Region{Box{{offset(), 0.9 + offset()}, {2 + offset(), 1 + offset()}}}, {Field::displacement}, ""}};
  const Histories run(scene);
  // At rest: the hinge carries the weight.
  EXPECT_NEAR(run.last("momentum.x"), 0, 0.02);
  EXPECT_NEAR(run.last("momentum.y"), 0, 0.02);
  EXPECT_NEAR(run.last("top.displacement.x"), 0, 1e-3);
  // The particles' row is half a spacing, a sixteenth, below the edge: strain is at most 10 / E = 0.01, and it
  // was stressed while it was pulled.
  EXPECT_NEAR(run.last("top.displacement.y"), 0, 0.01);
}

TEST(Hinges, HoldAPatchAloneAndLetTheRestTurn) {
  Scene scene = block(10000);
  scene.boundaries = {
      {"pin", {}, test::hinge(test::surface("block", Edge::left, Box{{-1, 0.4}, {1, 0.6}}), HingeKind::mean)}};
  scene.loads = {{"gravity", BodyForce{{0, -1}, {}}}};
  scene.analysis.end_time = 0.5;
  const Histories run(scene);
  // A stiff pendulum about the middle of the left edge: I a = m g l with I = m (4 l^2 / 3 + h^2 / 12), l = 1.
  const double rate = 1 / (4.0 / 3 + 1.0 / 12);
  EXPECT_NEAR(run.last("momentum.y"), -2 * rate * 0.5, 0.05 * 2 * rate * 0.5);
}

TEST(Hinges, CarryABodyThroughCellsWithoutAStrain) {
  for (const char* scheme : {"USL", "MUSL", "TLMPM"})
    for (const HingeKind kind : {HingeKind::whole, HingeKind::mean}) {
      Scene scene = block();
      scene.numerics.scheme = scheme;
      Hinge hinge = test::hinge(test::surface("block", Edge::left), kind);
      hinge.displacement = {"1.3*t", "0.7*t"};
      scene.boundaries = {{"carrier", {}, hinge}};
      scene.bodies[0].initial_velocity = {"1.3", "0.7"};
      scene.analysis.end_time = 2;
      const Histories run(scene);
      // Strains are rounded in every step, and the modulus of 1000 makes momentum of it.
      EXPECT_NEAR(run.last("momentum.x"), 2.6, 1000 * epsilon * run.steps()) << scheme;
      EXPECT_NEAR(run.last("momentum.y"), 1.4, 1000 * epsilon * run.steps()) << scheme;
      EXPECT_NEAR(run.last("energies.strain"), 0, 1000 * epsilon * run.steps()) << scheme;
    }
}

/// A pulse that runs along a bar.
Scene pulse(Dimension dimension, const std::string& scheme, double offset) {
  Scene scene;
  scene.name = "pulse";
  scene.domain.dimension = dimension;
  scene.domain.lower = {-1, dimension == Dimension::bar ? 0.0 : -0.5};
  scene.domain.upper = {12, dimension == Dimension::bar ? 0.0 : 1};
  scene.domain.cell_size = 0.125;
  scene.materials = {test::material("linear_elastic", 100, 0.25, 1)};
  scene.bodies = {{"bar", "solid", Box{{0, 0}, {10 + offset, 0.5}}, 2, {"0.01*exp(-(x-5)^2/0.5)", {}}}};
  if (dimension == Dimension::bar) scene.bodies[0].geometry = Box{{0, 0}, {10 + offset, 0}};
  scene.numerics.scheme = scheme;
  for (const Edge end : {Edge::left, Edge::right})
    scene.boundaries.push_back({end == Edge::left ? "left" : "right", {}, Absorbing{test::surface("bar", end)}});
  scene.analysis = {2, 0};
  scene.outputs.samples = 20;
  scene.outputs.snapshots = 1;
  return scene;
}

class Absorbed : public testing::TestWithParam<std::tuple<std::string, double>> {};
INSTANTIATE_TEST_SUITE_P(Schemes, Absorbed,
                         testing::Combine(testing::Values("USL", "MUSL", "TLMPM"), testing::Values(0.0, 0.07)));

/// Side walls without friction make a wave along the bar a plane one; if it is a shear wave, those that let
/// nothing but it move.
void make_plane(Scene& scene, Axis moves = Axis::x) {
  scene.domain.lower.y = 0;
  scene.domain.upper.y = 0.5;
  const Fixed sides{{moves == Axis::x ? Axis::y : Axis::x}};
  scene.boundaries.push_back({"bottom", Edge::bottom, sides});
  scene.boundaries.push_back({"top", Edge::top, sides});
}

TEST_P(Absorbed, WavesLeaveAPlaneBar) {
  Scene scene = pulse(Dimension::plane_strain, std::get<0>(GetParam()), std::get<1>(GetParam()));
  make_plane(scene);
  const Histories run(scene);
  // Both halves of the pulse have reached their ends at t = 0.5 and would be back at 1.
  EXPECT_LT(run.last("energies.total"), 0.02 * run.at(0, "energies.total"));
  EXPECT_GT(run.last("energies.dissipated"), 0.9 * run.at(0, "energies.total"));
  EXPECT_NEAR(run.last("energies.balance_error"), 0, 0.05);
}

/// Twice as stiff along the bar as across it.
MaterialDefinition wood(double angle) {
  return {"solid",
          1,
          "orthotropic_elastic",
          {{"youngs_modulus_1", 100},
           {"youngs_modulus_2", 50},
           {"youngs_modulus_3", 50},
           {"poissons_ratio_12", 0.2},
           {"poissons_ratio_23", 0.2},
           {"poissons_ratio_31", 0.1},
           {"shear_modulus_12", 60},
           {"shear_modulus_23", 10},
           {"shear_modulus_31", 60},
           {"angle_z", angle}}};
}

/// The share of a pulse's energy that comes back from the ends.
double returned(const Scene& scene) {
  const Histories run(scene);
  return run.last("energies.total") / run.at(0, "energies.total");
}

TEST(Absorbing, FitsTheWavesOfAnOrthotropicBody) {
  for (const double angle : {0.0, std::numbers::pi / 2}) {
    Scene scene = pulse(Dimension::plane_strain, "TLMPM", 0);
    scene.materials = {wood(angle)};
    make_plane(scene);
    EXPECT_LT(returned(scene), 0.02);
    scene.bodies[0].initial_velocity = {{}, *scene.bodies[0].initial_velocity.x};
    scene.boundaries.erase(scene.boundaries.begin() + 2, scene.boundaries.end());
    make_plane(scene, Axis::y);
    EXPECT_LT(returned(scene), 0.02) << "shear";
  }
}

TEST(Absorbing, OfAnInclinedMaterialIsRefused) {
  Scene scene = pulse(Dimension::plane_strain, "MUSL", 0);
  scene.materials = {wood(0.3)};
  try {
    validate(scene);
    FAIL() << "was let through";
  } catch (const InvalidScene& refused) {
    ASSERT_EQ(refused.violations().size(), 2u);
    EXPECT_EQ(refused.violations()[0].path, "boundaries[0].absorbing.surface");
    EXPECT_NE(refused.violations()[0].problem.find("inclined"), std::string::npos);
  }
}

TEST(Absorbing, FitsTheWavesOfAFluid) {
  Scene scene = pulse(Dimension::plane_strain, "MUSL", 0);
  scene.materials = {{"solid", 1, "tait_fluid", {{"bulk_modulus", 100}}}};
  make_plane(scene);
  EXPECT_LT(returned(scene), 0.02);
  // Nothing holds back what slides along an edge of a fluid.
  scene.bodies[0].initial_velocity = {{}, "0.01"};
  scene.boundaries.erase(scene.boundaries.begin() + 2, scene.boundaries.end());
  scene.boundaries.push_back({"all", Box{{-1, 0}, {12, 0.5}}, Fixed{{Axis::x}}});
  EXPECT_NEAR(returned(scene), 1, 1e-9);
}

}  // namespace
}  // namespace trajan
