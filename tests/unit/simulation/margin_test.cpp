#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "solver/analyses/run.h"
#include "solver/executors/layout.h"
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

/// Points of a surface may be in other cells than their particles, so that with a load on one, be it of nothing,
/// windows have a margin.
Scene loaded(Scene scene) {
  EdgeTraction nothing;
  nothing.body = "block", nothing.edge = Edge::right;
  scene.loads = {{"nothing", nothing}};
  return scene;
}

TEST_P(Margins, ChangeNothingWhereParticlesStay) {
  test::Memory without, with;
  ASSERT_EQ(run(validate(scene()), {1, 1e9, {}}, without, nullptr).end, RunEnd::finished);
  ASSERT_EQ(run(validate(loaded(scene())), {1, 1e9, {}}, with, nullptr).end, RunEnd::finished);
  // Places are counted from a window's first node, so that rounding of them differs by some 1e-15 a step.
  const auto nearly = testing::Pointwise(testing::DoubleNear(1e-12), with.snapshots.back().velocity);
  EXPECT_THAT(without.snapshots.back().velocity, nearly);
  EXPECT_GT(std::ranges::max(without.snapshots.back().velocity), 0.5);
}

TEST_P(Margins, AreOnlyWhereTheyAreNeeded) {
  const auto margin_of = [](const Scene& scene) {
    const Model model = validate(scene);
    return Executor(model, 1).tiles().layout().margin;
  };
  EXPECT_EQ(margin_of(scene()), Margin::none);
  EXPECT_EQ(margin_of(loaded(scene())), Margin::one_cell);
  Scene drifting = scene();
  drifting.numerics.scheme = "MUSL";
  EXPECT_EQ(margin_of(drifting), Margin::one_cell);
}

}  // namespace
}  // namespace trajan
