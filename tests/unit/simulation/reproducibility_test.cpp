#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/transfers/transfer.h"
#include "tests/unit/simulation/scenes.h"

namespace trajan::reproducibility_test {
namespace {

/// Everything that adds up in some order: a collision, so that particles change tiles, with loads.
Scene busy(const std::string& scheme) {
  Scene scene = test::discs(0.04);
  scene.numerics.scheme = scheme;
  scene.analysis = {2.5, 0.01};
  scene.outputs.samples = 10;
  scene.outputs.snapshots = 2;
  scene.loads = {{"gravity", BodyForce{{0.01, -0.02}, {"one"}}},
                 {"push", PointForce{"two", {0.8, 1.0}, {0.1, -0.2}}, Ramp{0, 1, true}}};
  scene.outputs.probes = {{"edge", Vector{0.2, 0.4}, {Field::displacement, Field::stress}, ""},
                          {"disc", Region{Disc{{0.2, 0.2}, 0.1}}, {Field::position, Field::velocity}, "one"}};
  return scene;
}

/// A scheme, or a transfer in the default scheme, or floats: with shape functions that need their gradients, or
/// laws that are computed in floats, too.
class Reproduction : public testing::TestWithParam<std::string> {
 protected:
  Model model() const {
    Scene scene = busy(Numerics{}.scheme);
    if (GetParam().starts_with(float_precision)) {
      scene.numerics.precision = float_precision;
      if (GetParam().ends_with("cpgimp")) scene.numerics.shape_functions = "cpgimp";
      if (GetParam().ends_with("TLMPM")) {
        scene.numerics.scheme = "TLMPM";
        scene.materials[0].law = "neo_hookean";
      }
      return validate(scene);
    }
    if (!find_transfer(GetParam())) return validate(busy(GetParam()));
    scene.numerics.shape_functions = "quadratic_bspline";
    scene.numerics.transfer = GetParam();
    return validate(scene);
  }
};
INSTANTIATE_TEST_SUITE_P(Schemes, Reproduction, testing::Values("USL", "MUSL", "TLMPM"),
                         [](const auto& named) { return named.param; });
INSTANTIATE_TEST_SUITE_P(Floats, Reproduction, testing::Values("FLOAT_cpgimp", "FLOAT_MUSL", "FLOAT_TLMPM"),
                         [](const auto& named) { return named.param; });
INSTANTIATE_TEST_SUITE_P(Transfers, Reproduction,
                         testing::ValuesIn(std::vector<std::string>(transfer_names().begin(),
                                                                    transfer_names().end())),
                         [](const auto& named) { return named.param; });

void expect_same_bits_on_any_number_of_threads(const Model& model) {
  test::Memory one;
  ASSERT_EQ(run(model, {1, 1e9, {}}, one, nullptr).end, RunEnd::finished);
  for (int threads : {2, 3}) {
    test::Memory many;
    ASSERT_EQ(run(model, {threads, 1e9, {}}, many, nullptr).end, RunEnd::finished);
    EXPECT_EQ(many.rows, one.rows) << threads;
    EXPECT_EQ(many.snapshots.back().position, one.snapshots.back().position) << threads;
    EXPECT_EQ(many.snapshots.back().velocity, one.snapshots.back().velocity) << threads;
  }
}

TEST_P(Reproduction, GivesTheSameBitsOnAnyNumberOfThreads) { expect_same_bits_on_any_number_of_threads(model()); }

TEST_P(Reproduction, GoesOnFromAnyCheckpointWithTheSameBits) {
  const Model model = this->model();
  test::Memory whole;
  ASSERT_EQ(run(model, {1, 0, {}}, whole, nullptr).end, RunEnd::finished);
  ASSERT_EQ(whole.checkpoints.size(), 9u);
  for (const Checkpoint& checkpoint : whole.checkpoints) {
    test::Memory rest;
    ASSERT_EQ(run(model, {2, 1e9, checkpoint}, rest, nullptr).end, RunEnd::finished);
    for (auto row = static_cast<std::size_t>(checkpoint.sample) + 1; row < whole.rows.size(); ++row)
      EXPECT_EQ(rest.rows.at(row), whole.rows[row]) << row;
    EXPECT_EQ(rest.snapshots.back().velocity, whole.snapshots.back().velocity);
  }
}

/// So wide that tiles are not simply row by row, and may be updated in another order than they are given: in a
/// plane 20 x 10 tiles, in space 19 x 10 x 2.
Scene slab(Dimension dimension) {
  Scene scene;
  scene.name = "slab";
  scene.domain = {dimension, {0, 0}, {17, 9}, 0.1, 1};
  scene.materials = {test::material("neo_hookean", 100, 0.3, 1)};
  scene.bodies = {{"slab", "solid", Box{{0.5, 0.5}, {15.7, 8.3}}, 1, {"sin(x)*cos(2*y)", "0.5*sin(y+x)"}}};
  if (dimension == Dimension::solid) {
    scene.domain = {dimension, {0, 0, 0}, {8, 5, 1}, 0.1};
    scene.bodies = {{"slab",
                     "solid",
                     Box{{0.3, 0.3, 0.3}, {7.7, 4.3, 0.5}},
                     1,
                     {"sin(x)*cos(2*y)", "0.5*sin(y+x)", "sin(7*x)"}}};
  }
  scene.analysis = {0.04, 0.005};
  scene.outputs.samples = 2;
  scene.outputs.snapshots = 1;
  return scene;
}

class WideBody : public testing::TestWithParam<std::tuple<Dimension, const char*>> {};
INSTANTIATE_TEST_SUITE_P(DimensionsAndSchemes, WideBody,
                         testing::Combine(testing::Values(Dimension::plane_strain, Dimension::solid),
                                          testing::Values("MUSL", "TLMPM")));

TEST_P(WideBody, HasTheSameBitsOnAnyNumberOfThreads) {
  const auto& [dimension, scheme] = GetParam();
  Scene scene = slab(dimension);
  scene.numerics.scheme = scheme;
  expect_same_bits_on_any_number_of_threads(validate(scene));
}

TEST(Stopping, EndsTheRunWhenItIsAskedTo) {
  Scene scene = test::discs(0.02);
  scene.analysis.end_time = 1e6;
  scene.domain.lower = {-1e6, -1e6};
  scene.domain.upper = {1e6, 1e6};
  const Model model = validate(scene);
  test::Memory memory;
  int asked = 0;
  const RunResult result = run(model, {}, memory, [&](const RunProgress& progress) {
    EXPECT_GT(progress.step, 0);
    return ++asked == 2;
  });
  EXPECT_EQ(result.end, RunEnd::stopped);
  EXPECT_EQ(asked, 2);
}

}  // namespace
}  // namespace trajan::reproducibility_test
