#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/unit/simulation/scenes.h"

/// Contact in every dimension, with every transfer, across periodic axes, and of three bodies.
namespace trajan {
namespace {

using test::column;
using test::recorded;

constexpr double gap = 0.125;  // half a cell

Vector along_axes(Dimension dimension, double x, double y, double z) {
  const int axes = grid_axes(dimension);
  return {x, axes > 1 ? y : 0, axes > 2 ? z : 0};
}

Scene empty(Dimension dimension) {
  Scene scene;
  scene.name = "meeting";
  scene.domain = {dimension, {}, along_axes(dimension, 4, 4, 4), 0.25};
  scene.materials = {test::material("neo_hookean", 1000, 0.3, 1)};
  scene.numerics.shape_functions = "quadratic_bspline";
  scene.outputs.samples = 10;
  scene.outputs.snapshots = 1;
  scene.contacts = {{{}, 0.2}};
  return scene;
}

/// A block runs into a smaller one; in axisymmetric scenes along the axis.
Scene meeting(Dimension dimension) {
  Scene scene = empty(dimension);
  if (dimension == Dimension::axisymmetric) {
    scene.bodies = {{"first", "solid", Box{{0, 1}, {1, 2}}, 2, {{}, "1"}},
                    {"second", "solid", Box{{0, 2 + gap}, {0.8, 2.5 + gap}}, 2, {}}};
    return scene;
  }
  const auto at = [&](double x, double y) { return along_axes(dimension, x, y, y); };
  scene.bodies = {{"first", "solid", Box{at(1, 1), at(2, 2)}, 2, {"1"}},
                  {"second", "solid", Box{at(2 + gap, 1.1), at(2.5 + gap, 1.9)}, 2, {}}};
  if (grid_axes(dimension) > 1) scene.bodies[0].initial_velocity.y = "0.5";
  if (grid_axes(dimension) > 2) scene.bodies[0].initial_velocity.z = "0.25";
  return scene;
}

/// Free flight until less is left than a step goes on, at most 0.03 of the gap; then impulses are equal and
/// opposite, and consume energy.
void expect_right(Scene scene) {
  scene.analysis.end_time = 0.96 * gap;
  const Model before = validate(scene);
  const test::Memory flight = recorded(before);
  const double kinetic = flight.rows.front()[column(before, "energies.kinetic")];
  EXPECT_NEAR(flight.rows.back()[column(before, "energies.kinetic")], kinetic, 1e-12 * kinetic);
  EXPECT_EQ(flight.rows.back()[column(before, "energies.dissipated")], 0);

  scene.analysis.end_time = gap + 0.03;
  const Model model = validate(scene);
  const test::Memory memory = recorded(model);
  const std::vector<double>&first = memory.rows.front(), &last = memory.rows.back();
  constexpr std::array<const char*, 3> momenta = {"momentum.x", "momentum.y", "momentum.z"};
  // Hoop stresses push outwards.
  for (int axis = model.dimension == Dimension::axisymmetric; axis < grid_axes(model.dimension); ++axis) {
    const std::size_t c = column(model, momenta[static_cast<std::size_t>(axis)]);
    // Roundings of some hundred steps.
    EXPECT_NEAR(last[c], first[c], 1e-13) << axis;
  }
  EXPECT_GT(last[column(model, "energies.dissipated")], 0);
  EXPECT_LT(last[column(model, "energies.total")], first[column(model, "energies.total")]);
}

class ContactInDimension : public testing::TestWithParam<Dimension> {};

TEST_P(ContactInDimension, ActsNotEarlyAndKeepsMomentum) { expect_right(meeting(GetParam())); }

INSTANTIATE_TEST_SUITE_P(Contact, ContactInDimension,
                         testing::Values(Dimension::bar, Dimension::plane_stress, Dimension::plane_strain,
                                         Dimension::axisymmetric, Dimension::solid),
                         [](const auto& tested) { return "Dimension" + std::to_string(tested.index); });

class ContactWithTransfer : public testing::TestWithParam<const char*> {};

TEST_P(ContactWithTransfer, ActsNotEarlyAndKeepsMomentum) {
  Scene scene = meeting(Dimension::plane_strain);
  scene.numerics.transfer = GetParam();
  expect_right(scene);
}

INSTANTIATE_TEST_SUITE_P(Contact, ContactWithTransfer, testing::Values("FLIP", "APIC", "XPIC", "FMPM"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(ContactInAllScenes, ActsAcrossTheSeamOfAPeriodicAxis) {
  Scene scene = empty(Dimension::plane_strain);
  // Through the seam at x = 3.75, which is x = 0: both move, so that the gap between them is twice as large.
  scene.domain.upper.x = 3.75;
  scene.bodies = {{"first", "solid", Box{{2.65, 1}, {3.65, 2}}, 2, {"1", "0.5"}},
                  {"second", "solid", Box{{2 * gap - 0.1, 1.1}, {2 * gap + 0.4, 1.9}}, 2, {"-1", {}}}};
  scene.boundaries = {{"round", {}, Periodic{Axis::x}}};
  expect_right(scene);
}

class ContactWithScheme : public testing::TestWithParam<const char*> {};

TEST_P(ContactWithScheme, TakesEnergyAndGivesNone) {
  Scene scene = empty(Dimension::plane_strain);
  scene.domain.lower = {-4, -4};
  scene.bodies = {{"left", "solid", Disc{{-1.01, 0}, 1}, 2, {"0.5", "0.2"}},
                  {"right", "solid", Disc{{1.01, 0}, 1}, 2, {"-0.5", "-0.2"}}};
  scene.numerics.scheme = GetParam();
  scene.numerics.shape_functions = "gimp";
  scene.analysis.end_time = 0.5;
  scene.outputs.samples = 50;
  const Model model = validate(scene);
  for (const std::vector<double>& row : recorded(model).rows)
    EXPECT_LT(row[column(model, "energies.balance_error")], 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Contact, ContactWithScheme, testing::Values("MUSL", "USF", "USAVG", "USL"),
                         [](const auto& tested) { return std::string(tested.param); });

/// By symmetry what is in the middle stays there, and the three meet at the same nodes: it is half a cell wide.
TEST(ContactInAllScenes, OfThreeBodiesKeepsMomentumAndSymmetry) {
  Scene scene = empty(Dimension::plane_strain);
  scene.bodies = {{"left", "solid", Box{{0.875 - gap, 1}, {1.875 - gap, 2}}, 2, {"1", {}}},
                  {"right", "solid", Box{{2.125 + gap, 1}, {3.125 + gap, 2}}, 2, {"-1", {}}},
                  {"middle", "solid", Box{{1.875, 1}, {2.125, 2}}, 2, {}}};
  scene.outputs.probes = {{"middle", Region{}, {Field::velocity}, "middle"}};
  expect_right(scene);
  scene.analysis.end_time = gap + 0.03;
  const Model model = validate(scene);
  const test::Memory memory = recorded(model);
  // Roundings of what contacts of three bodies find in rounds.
  EXPECT_NEAR(memory.rows.back()[column(model, "middle.velocity.x")], 0, 1e-12);
}

}  // namespace
}  // namespace trajan
