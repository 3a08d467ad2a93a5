#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "solver/schemes/kernels.h"

/// What particles give and get that lie in rows of cells, four to a cell, must be what they give and get cell by
/// cell. In floats by linear functions in a plane kernels work on such rows at once.
namespace trajan {
namespace {

struct Particle {
  double at[2];  ///< in cells of the window, its own from 1 on
  float velocity[2], force[4];
};

constexpr int side = 8;

/// Of the upper half of a tile and part of its lower one, cell by cell in the order of memory: in most cells four,
/// in some others as many as chance has it.
std::vector<Particle> random_particles(double share_of_others) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(0, 1);
  std::uniform_int_distribution<int> some(0, 6);
  std::vector<Particle> particles;
  for (int y = 1; y <= 4; ++y)
    for (int x = 1; x <= side; ++x) {
      const int count = anywhere(random) < share_of_others ? some(random) : 4;
      for (int i = 0; i < count && particles.size() < block_size; ++i) {
        Particle p{{x + anywhere(random), y + anywhere(random)}, {}, {}};
        for (float& v : p.velocity) v = static_cast<float>(anywhere(random) - 0.5);
        for (float& f : p.force) f = static_cast<float>(anywhere(random) - 0.5);
        particles.push_back(p);
      }
    }
  return particles;
}

/// What particles have given to nodes and got from them.
struct Exchanged {
  int rows;  ///< that were worked on at once
  std::vector<double> sums;
  std::vector<float> acceleration[2], velocity[2], gradient[4];
};

Exchanged exchange(const std::vector<Particle>& particles, Margin margin) {
  const TransferKernels& kernels = *trajan::kernels().floats.transfer("linear", Dimension::plane_strain, margin);
  const Layout& layout = kernels.layout;
  TransferScratch<float> scratch;
  scratch.prepare(static_cast<std::size_t>(quantities(node_vectors, 2) * layout.window_nodes), 0, 0);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> anywhere(-1, 1);
  for (float& node : scratch.window) node = anywhere(random);
  SweepConstants sweep;
  sweep.cell = sweep.inverse_cell = 1;
  BodyConstants body;
  body.mass = 1.75;
  AlignedDoubles sums(static_cast<std::size_t>(quantities(sum_vectors, 2) * layout.window_nodes));
  std::vector<double> position[2];
  std::vector<float> velocity[2];
  Block block;
  for (int a = 0; a < 2; ++a) {
    for (const Particle& p : particles) position[a].push_back(p.at[a]), velocity[a].push_back(p.velocity[a]);
    block.arrays[static_cast<std::size_t>(Attribute::position_x) + static_cast<std::size_t>(a)] =
        position[a].data();
    block.floats[static_cast<std::size_t>(Attribute::velocity_x) + static_cast<std::size_t>(a)] =
        velocity[a].data();
    block.lowest[a] = 1, block.highest[a] = side;
    sweep.faces[a] = 1000;
  }
  block.count = static_cast<int>(particles.size());
  block.body = &body, block.sweep = &sweep, block.scratch = &scratch, block.sums = sums.data();
  for (int f = 0; f < 4; ++f)
    for (int i = 0; i < block.count; ++i)
      scratch.narrow_force[f][i] = particles[static_cast<std::size_t>(i)].force[f];

  kernels.locate(block);
  EXPECT_EQ(scratch.trouble.left_window, 0);
  kernels.scatter_state(block);
  kernels.scatter_momentum(block);
  kernels.gather_acceleration(block);
  kernels.gather_motion(block);
  Exchanged all{scratch.cell_rows, {sums.begin(), sums.end()}, {}, {}, {}};
  const auto copy = [&](const BlockArray<float>& from) {
    return std::vector<float>(from.values, from.values + block.count);
  };
  for (int a = 0; a < 2; ++a) {
    all.acceleration[a] = copy(scratch.acceleration[a]);
    all.velocity[a] = copy(scratch.velocity[a]);
  }
  for (int g = 0; g < 4; ++g) all.gradient[g] = copy(scratch.gradient_of_grid()[g]);
  return all;
}

class CellRows : public testing::TestWithParam<std::tuple<double, Margin>> {};
INSTANTIATE_TEST_SUITE_P(SharesOfOthers, CellRows,
                         testing::Combine(testing::Values(0.0, 0.05, 0.3),
                                          testing::Values(Margin::none, Margin::one_cell)));

TEST_P(CellRows, GiveAndGetWhatTheirParticlesDoCellByCell) {
  const auto [others, margin] = GetParam();
  const std::vector<Particle> particles = random_particles(others);
  // The other way round no cell follows the one to its left.
  const Exchanged rows = exchange(particles, margin),
                  cells = exchange({particles.rbegin(), particles.rend()}, margin);
  EXPECT_EQ(cells.rows, 0);
  if (__builtin_cpu_supports("avx2") && others < 0.1) {
    EXPECT_GE(rows.rows, others > 0 ? 1 : 4);
  }
  // A node's sums have some 32 terms of about one, each rounded some five times.
  constexpr double rounding = 160 * std::numeric_limits<float>::epsilon();
  EXPECT_THAT(rows.sums, testing::Pointwise(testing::DoubleNear(rounding), cells.sums));
  const auto expect_same = [](const std::vector<float>& got, std::vector<float> backwards) {
    std::ranges::reverse(backwards);
    // Products of two weights and a number of about one, four of them.
    EXPECT_THAT(got,
                testing::Pointwise(testing::FloatNear(16 * std::numeric_limits<float>::epsilon()), backwards));
  };
  for (int a = 0; a < 2; ++a) {
    expect_same(rows.acceleration[a], cells.acceleration[a]);
    expect_same(rows.velocity[a], cells.velocity[a]);
  }
  for (int g = 0; g < 4; ++g) expect_same(rows.gradient[g], cells.gradient[g]);
}

}  // namespace
}  // namespace trajan
