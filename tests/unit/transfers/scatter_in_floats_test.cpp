#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "solver/transfers/scatter.h"

/// Compiled for floats, of which wide functions take two particles at a time.
namespace trajan::test {
namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

/// Particles in runs of so many, with random weights, velocities and forces; past the last one is nothing that may
/// be used.
template <int Nodes, Layout L>
class RandomBlock {
 public:
  static constexpr int D = L.dimensions;

  explicit RandomBlock(const std::vector<int>& runs) {
    for (int length : runs) count_ += length;
    s_.runs = static_cast<int>(runs.size());
    int first = 0;
    for (int r = 0; r < s_.runs; ++r) {
      s_.run_begin[r] = first;
      for (int i = 0; i < runs[r]; ++i) s_.cell[first + i] = 2 * r;
      first += runs[r];
    }
    s_.run_begin[s_.runs] = first;
    for (int a = 0; a < D; ++a) {
      for (int n = 0; n < Nodes; ++n) {
        fill(s_.weight[a][n]);
        fill(s_.slope[a][n]);
      }
      for (int b = 0; b < D; ++b) fill(s_.narrow_force[D * a + b]);
      for (int i = 0; i < count_; ++i) velocity_[a].push_back(number_(random_));
      velocity_[a].push_back(nothing);
      block_.floats[static_cast<int>(Attribute::velocity_x) + a] = velocity_[a].data();
    }
    body_.mass = 1.75;
    block_.body = &body_;
    block_.scratch = &s_;
    block_.count = count_;
    block_.sums = sums_.data();
  }

  /// How far what a scatter has given to the nodes is from sums in doubles, per unit roundoff of floats and sum of
  /// magnitudes: the largest.
  double largest_error() {
    scatter_state<ProductStencil<Nodes, L, ShapeSlopes>, L>(block_);
    std::vector<double> exact(sums_.size()), magnitude(sums_.size());
    for (int i = 0; i < count_; ++i)
      for (int node = 0; node < power(Nodes, D); ++node) add_terms(i, node, exact, magnitude);
    double largest = 0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      if (sums_[k] == exact[k]) continue;
      const double error =
          std::abs(sums_[k] - exact[k]) * 2 / (magnitude[k] * std::numeric_limits<float>::epsilon());
      if (std::isnan(error)) return HUGE_VAL;
      largest = std::max(largest, error);
    }
    return largest;
  }

 private:
  static constexpr int power(int base, int exponent) {
    return exponent == 0 ? 1 : base * power(base, exponent - 1);
  }
  void fill(RealArray& values) {
    for (int i = 0; i < block_size + 2 * block_padding; ++i) values[i] = i < count_ ? number_(random_) : nothing;
  }
  void add_terms(int i, int node, std::vector<double>& exact, std::vector<double>& magnitude) const {
    const int along[3] = {node % Nodes, node / Nodes % Nodes, node / Nodes / Nodes};
    double weight = 1, slope[3] = {1, 1, 1};
    int at = s_.cell[i];
    for (int a = 0; a < D; ++a) {
      at += along[a] * L.window_stride(a);
      weight *= s_.weight[a][along[a]][i];
      for (int b = 0; b < D; ++b) slope[b] *= (a == b ? s_.slope : s_.weight)[a][along[a]][i];
    }
    const auto add = [&](int quantity, double term) {
      exact[quantity * L.window_nodes + at] += term;
      magnitude[quantity * L.window_nodes + at] += std::abs(term);
    };
    add(quantity_mass, body_.mass * weight);
    for (int a = 0; a < D; ++a) {
      add(quantity(sum_momentum, a, D), body_.mass * weight * velocity_[a][i]);
      for (int b = 0; b < D; ++b) add(quantity(sum_force, a, D), -slope[b] * s_.narrow_force[a * D + b][i]);
    }
  }

  std::mt19937 random_{7};
  std::uniform_real_distribution<float> number_{-1, 1};
  std::unique_ptr<RealScratch> scratch_ = std::make_unique<RealScratch>();
  RealScratch& s_ = *scratch_;
  std::array<std::vector<float>, 3> velocity_;
  BodyConstants body_;
  Block block_;
  int count_ = 0;
  std::vector<double> sums_ = std::vector<double>(quantities(sum_vectors, D) * L.window_nodes);
};

/// A term is a product of D + 2 numbers, rounded as often at most, and a node gets at most 8 of a run, D for each
/// particle's force: so many sums are rounded.
constexpr double roundings(int axes, int longest_run) { return axes + 2 + axes * longest_run; }

template <int Nodes, int D>
void expect_sums() {
  constexpr Layout layout{D, Reach::wide};
  for (const std::vector<int>& runs : {std::vector{1}, {2}, {3}, {1, 1, 1}, {5, 2, 1, 3}, {4, 8, 7}}) {
    SCOPED_TRACE(testing::PrintToString(runs));
    EXPECT_LE((RandomBlock<Nodes, layout>(runs).largest_error()), roundings(D, 8)) << Nodes << ' ' << D;
  }
}

TEST(ScatterInFloats, GivesWhatAllParticlesGiveWhetherTheyAreEvenOrOddInNumber) {
  expect_sums<3, 1>();
  expect_sums<3, 2>();
  expect_sums<3, 3>();
  expect_sums<4, 1>();
  expect_sums<4, 2>();
  expect_sums<4, 3>();
}

}  // namespace
}  // namespace trajan::test
