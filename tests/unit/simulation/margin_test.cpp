#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "solver/analyses/run.h"
#include "solver/executors/layout.h"
#include "solver/simulation/checkpoint_array.h"
#include "solver/simulation/executor.h"
#include "tests/unit/simulation/scenes.h"

namespace trajan {
namespace {

/// A body in some tiles along each axis, whose particles stay in their cells. Its faces lie within cells.
Scene block(Dimension dimension, const std::string& shape_functions) {
  Scene scene;
  scene.name = "block";
  scene.domain = {dimension, {0, 0}, {3, 3}, 0.1};
  scene.materials = {test::material("neo_hookean", 100, 0.3, 1)};
  scene.bodies = {{"block", "solid", Box{{0.53, 0.53}, {2.33, 1.93}}, 2, {"sin(x)*cos(2*y)", "0.5*sin(y+x)"}}};
  if (dimension == Dimension::solid) {
    scene.domain = {dimension, {0, 0, 0}, {2, 2, 2}, 0.1};
    scene.bodies = {{"block",
                     "solid",
                     Box{{0.33, 0.33, 0.33}, {1.33, 1.23, 0.93}},
                     2,
                     {"sin(x)*cos(2*y)", "0.5*sin(y+x)", "sin(7*x)"}}};
  }
  scene.numerics.scheme = "TLMPM";
  scene.numerics.shape_functions = shape_functions;
  scene.analysis = {0.05, 0.002};
  scene.outputs.samples = 2;
  scene.outputs.snapshots = 1;
  return scene;
}

class Margins : public testing::TestWithParam<std::tuple<Dimension, const char*>> {
 protected:
  Scene scene() const { return block(std::get<0>(GetParam()), std::get<1>(GetParam())); }
};
INSTANTIATE_TEST_SUITE_P(
    DimensionsAndShapes, Margins,
    testing::Combine(testing::Values(Dimension::plane_strain, Dimension::axisymmetric, Dimension::solid),
                     testing::Values("linear", "gimp", "quadratic_bspline", "cubic_bspline")));

/// The same motion far from the faces of a domain that is periodic, where windows have a margin.
Scene with_margin(Scene scene) {
  scene.boundaries.push_back({"far_away", {}, Periodic{Axis::y}});
  return scene;
}

/// A pressure that follows one side, and a traction on another.
Scene loaded(Scene scene) {
  Pressure pressure;
  pressure.surface = {"block", Edge::right}, pressure.pressure = 3;
  EdgeTraction traction;
  traction.body = "block", traction.edge = Edge::top, traction.traction = {0.5, 2};
  scene.loads = {{"pressure", pressure}, {"traction", traction}};
  return scene;
}

Scene updated_lagrangian(Scene scene) {
  scene.numerics.scheme = "MUSL";
  return scene;
}

/// A condition on a surface.
Scene hinged(Scene scene) {
  Hinge hinge;
  hinge.surface = {"block", Edge::left}, hinge.kind = HingeKind::whole, hinge.axes = {Axis::x};
  scene.boundaries.push_back({"hinge", {}, hinge});
  return scene;
}

Margin margin_of(const Scene& scene) {
  const Model model = validate(scene);
  return Executor(model, 1).tiles().layout().margin;
}

void expect_same_motion(const Scene& scene) {
  ASSERT_EQ(margin_of(with_margin(scene)), Margin::one_cell);
  test::Memory without, with;
  ASSERT_EQ(run(validate(scene), {1, 1e9, {}}, without, nullptr).end, RunEnd::finished);
  ASSERT_EQ(run(validate(with_margin(scene)), {1, 1e9, {}}, with, nullptr).end, RunEnd::finished);
  // Places are counted from a window's first node, so that rounding of them differs by some 1e-15 a step.
  const auto nearly = testing::Pointwise(testing::DoubleNear(1e-12), with.snapshots.back().velocity);
  EXPECT_THAT(without.snapshots.back().velocity, nearly);
  EXPECT_GT(std::ranges::max(without.snapshots.back().velocity), 0.5);
}

TEST_P(Margins, ChangeNothingWhereParticlesStay) { expect_same_motion(scene()); }

TEST_P(Margins, ChangeNothingUnderLoadsOnSurfaces) { expect_same_motion(loaded(scene())); }

TEST_P(Margins, ChangeNothingWithAHinge) { expect_same_motion(hinged(scene())); }

TEST_P(Margins, AreOnlyWhereTheyAreNeeded) {
  EXPECT_EQ(margin_of(scene()), Margin::none);
  // Domains of particles may reach into other cells than theirs.
  const Margin at_surfaces = scene().numerics.shape_functions == "gimp" ? Margin::one_cell : Margin::none;
  EXPECT_EQ(margin_of(loaded(scene())), at_surfaces);
  EXPECT_EQ(margin_of(hinged(scene())), at_surfaces);
}

/// Bodies whose particles begin to leave their tiles some time after they have begun to move.
using DriftingBody = Margins;
INSTANTIATE_TEST_SUITE_P(
    DimensionsAndShapes, DriftingBody,
    testing::Combine(testing::Values(Dimension::plane_strain, Dimension::axisymmetric, Dimension::solid),
                     testing::Values("linear", "gimp", "quadratic_bspline", "cubic_bspline")));

bool has_margin(const Checkpoint& checkpoint) {
  return checkpoint_array<std::int64_t>(checkpoint, "order").at(2) != 0;
}

TEST_P(DriftingBody, MovesAsIfItHadHadMarginsFromTheFirst) { expect_same_motion(updated_lagrangian(scene())); }

TEST_P(DriftingBody, MovesAsIfItHadHadMarginsUnderLoadsOnSurfaces) {
  expect_same_motion(loaded(updated_lagrangian(scene())));
}

TEST_P(DriftingBody, MovesAsIfItHadHadMarginsWithAHinge) {
  expect_same_motion(hinged(updated_lagrangian(scene())));
}

TEST_P(DriftingBody, GoesOnFromCheckpointsWithAndWithoutMarginsWithTheSameBits) {
  Scene drifting = loaded(updated_lagrangian(scene()));
  drifting.outputs.samples = 25;
  const Model model = validate(drifting);
  test::Memory whole;
  ASSERT_EQ(run(model, {1, 0, {}}, whole, nullptr).end, RunEnd::finished);
  ASSERT_EQ(has_margin(whole.checkpoints.front()), margin_of(drifting) == Margin::one_cell);
  ASSERT_TRUE(has_margin(whole.checkpoints.back()));
  const std::ptrdiff_t first_with =
      std::ranges::find_if(whole.checkpoints, has_margin) - whole.checkpoints.begin();
  for (const std::ptrdiff_t from : {std::ptrdiff_t{0}, std::max(first_with - 1, std::ptrdiff_t{0}), first_with}) {
    test::Memory rest;
    ASSERT_EQ(run(model, {2, 1e9, whole.checkpoints[static_cast<std::size_t>(from)]}, rest, nullptr).end,
              RunEnd::finished);
    EXPECT_EQ(rest.rows.back(), whole.rows.back());
    EXPECT_EQ(rest.snapshots.back().velocity, whole.snapshots.back().velocity);
  }
}

/// Particles that carry loads lie on faces between tiles, and the body ends there.
TEST(Margins, ChangeNothingWhereCarriersLieOnFacesOfTiles) {
  Scene scene = loaded(block(Dimension::plane_strain, "cubic_bspline"));
  scene.domain.cell_size = 0.125;
  // Numbers that are exact: 0.03125 more than the faces at 16 cells.
  scene.bodies[0].geometry = Box{{0.53125, 0.53125}, {2.03125, 2.03125}};
  const Model model = validate(scene);
  Executor executor(model, 1);
  executor.begin();
  const std::vector<double>& x = executor.bodies()[0][Attribute::position_x];
  ASSERT_EQ(std::ranges::max(x), 2);
  expect_same_motion(scene);
}

}  // namespace
}  // namespace trajan
