#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "solver/simulation/checkpoint_array.h"
#include "solver/simulation/executor.h"
#include "tests/unit/simulation/scenes.h"

/// In which tile particles are, and how they lie in it.
namespace trajan {
namespace {

constexpr double cell = 0.1;

/// A body whose faces are nodes: in a plane a multiple of a tile's cells wide.
Scene body_between_nodes(Dimension dimension, const std::string& shape_functions, int particles_per_side) {
  Scene scene;
  scene.name = "body";
  scene.materials = {test::material("neo_hookean", 100, 0.3, 1)};
  scene.domain = {dimension, {0, 0}, {3.2, 3.2}, cell};
  scene.bodies = {{"body", "solid", Box{{0.8, 0.8}, {2.4, 2.4}}, particles_per_side, {"0.1*sin(x)", "0.1*y"}}};
  if (dimension == Dimension::solid) {
    scene.domain = {dimension, {0, 0, 0}, {2.4, 2.4, 2.4}, cell};
    scene.bodies[0].geometry = Box{{0.8, 0.8, 0.8}, {1.6, 1.6, 1.6}};
    scene.bodies[0].initial_velocity = {"0.1*sin(x)", "0.1*y", "0.1*z"};
  }
  scene.numerics.scheme = "TLMPM";
  scene.numerics.shape_functions = shape_functions;
  scene.analysis = {0.05, 0.002};
  scene.outputs.samples = 2;
  return scene;
}

/// The node that a particle's stencil begins with, along an axis, of functions that reach so far.
std::int64_t first_node(Reach reach, double position) {
  // Up to rounding: particles may lie in the middle between nodes, where both would do.
  const double at = position / cell;
  return static_cast<std::int64_t>(std::floor(reach == Reach::staggered ? at - 0.5 + 1e-9 : at));
}

class Sorting : public testing::TestWithParam<std::tuple<Dimension, const char*, int>> {
 protected:
  Model model() const {
    const auto& [dimension, shape_functions, particles_per_side] = GetParam();
    return validate(body_between_nodes(dimension, shape_functions, particles_per_side));
  }
};
INSTANTIATE_TEST_SUITE_P(
    DimensionsShapesAndParticles, Sorting,
    testing::Combine(testing::Values(Dimension::plane_strain, Dimension::axisymmetric, Dimension::solid),
                     testing::Values("linear", "gimp", "quadratic_bspline"), testing::Values(1, 2, 3)));

TEST_P(Sorting, PutsParticlesInTheTileThatOwnsTheirFirstNode) {
  const Model scene = model();
  Executor executor(scene, 2);
  executor.begin();
  const Tiles& tiles = executor.tiles();
  std::size_t particles = 0;
  for (const Tile& tile : tiles.tiles())
    for (std::uint32_t b = tile.first_block; b < tile.last_block; ++b) {
      const BlockRange& block = tiles.blocks()[b];
      for (std::uint32_t p = block.begin; p < block.begin + block.count; ++p, ++particles)
        for (int axis = 0; axis < tiles.layout().dimensions; ++axis) {
          const double x = executor.bodies()[0].component(Attribute::position_x, axis)[p];
          EXPECT_EQ(first_node(tiles.layout().reach, x) >> tiles.layout().tile_bits,
                    tile.at[static_cast<std::size_t>(axis)])
              << x;
        }
    }
  EXPECT_EQ(particles, executor.bodies()[0].size());
}

/// With one or three particles to a cell's side some lie in the middle between nodes, up to rounding to one side
/// or the other: windows need no margin for that.
TEST_P(Sorting, FindsNoneOutsideItsTileWhereAllStay) {
  test::Memory memory;
  ASSERT_EQ(run(model(), {1, 0, {}}, memory, nullptr).end, RunEnd::finished);
  EXPECT_EQ(checkpoint_array<std::int64_t>(memory.checkpoints.back(), "order").at(2), 0);
}

/// Of the eight particles of a strip each is in the next cell of the same row.
bool is_strip(const Executor& executor, std::uint32_t first) {
  const BodyParticles& body = executor.bodies()[0];
  const auto node = [&](int axis, std::uint32_t p) {
    return first_node(executor.tiles().layout().reach, body.component(Attribute::position_x, axis)[p]);
  };
  for (std::uint32_t i = 1; i < 8; ++i)
    if (node(0, first + i) != node(0, first) + i || node(1, first + i) != node(1, first)) return false;
  return true;
}

TEST(Sorting, MakesStripsOfFloatsInAPlane) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "there are none without AVX2";
  for (const std::string shape_functions : {"linear", "gimp", "quadratic_bspline", "cubic_bspline"}) {
    Scene scene = body_between_nodes(Dimension::plane_strain, shape_functions, 2);
    scene.numerics.precision = "FLOAT";
    const Model model = validate(scene);
    Executor executor(model, 1);
    executor.begin();
    const Tiles& tiles = executor.tiles();
    std::uint32_t strips = 0;
    for (const Tile& tile : tiles.tiles()) {
      const std::uint32_t begin = tile.first_block, end = tile.last_block;
      if (begin == end || tiles.blocks()[end - 1].begin + tiles.blocks()[end - 1].count !=
                              tiles.blocks()[begin].begin + 4 * tile_nodes)
        continue;
      for (std::uint32_t strip = 0; strip < tile_nodes / 2; ++strip, ++strips)
        EXPECT_TRUE(is_strip(executor, tiles.blocks()[begin].begin + 8 * strip))
            << shape_functions << ' ' << strip;
    }
    // Of four tiles all with linear functions, one with those that begin half a cell away from the body's faces.
    EXPECT_GE(strips, static_cast<std::uint32_t>(tile_nodes / 2)) << shape_functions;
  }
}

}  // namespace
}  // namespace trajan
