#pragma once

#include "solver/executors/layout.h"
#include "solver/transfers/cell_rows.h"

/// Between rows of cells and nodes, by linear functions in a plane.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The numbers of the cells before, of the first one zero.
__attribute__((always_inline)) inline Cells of_cell_before(Cells cells) {
  return __builtin_shufflevector(cells, Cells{}, 8, 0, 1, 2, 3, 4, 5, 6);
}

/// What the cells of a row give to their corners, x first.
using Corners = std::array<Cells, 4>;

/// Adds it to the nodes, the first of which is at `to`.
template <Layout L>
__attribute__((always_inline)) inline void add_to_corners(double* to, const Corners& corner) {
  const auto add_side = [](double* at, Cells left, Cells right) __attribute__((always_inline)) {
    add(at, left + of_cell_before(right));
    at[cells_of_row] += static_cast<double>(right[cells_of_row - 1]);
  };
  add_side(to, corner[0], corner[1]);
  add_side(to + L.window_stride(1), corner[2], corner[3]);
}

__attribute__((always_inline)) inline Cells sum_products(const ByRank& a, const ByRank& b) {
  Cells sum = a[0] * b[0];
#pragma GCC unroll 3
  for (std::size_t k = 1; k < a.size(); ++k) sum = multiply_add(a[k], b[k], sum);
  return sum;
}

/// What a row's particles of equal mass give to their nodes; `sums`: of a quantity at the row's first node.
template <Layout L>
class RowScatter {
 public:
  __attribute__((always_inline)) RowScatter(const Block& block, int first)
      : mass_(Real(block.body->mass)), first_(first) {
    const RealScratch& s = scratch_of(block);
    x_ = load_by_rank(s.place[0].values + first), y_ = load_by_rank(s.place[1].values + first);
#pragma GCC unroll 4
    for (std::size_t k = 0; k < x_.size(); ++k) {
      from_x_[k] = 1 - x_[k], from_y_[k] = 1 - y_[k];
      weights_[0][k] = from_x_[k] * from_y_[k];
      weights_[1][k] = x_[k] * from_y_[k];
      weights_[2][k] = from_x_[k] * y_[k];
      weights_[3][k] = x_[k] * y_[k];
    }
  }

  __attribute__((always_inline)) void add_mass(double* sums) const {
    Corners corner;
#pragma GCC unroll 4
    for (std::size_t n = 0; n < corner.size(); ++n) {
      const ByRank& w = weights_[n];
      corner[n] = mass_ * ((w[0] + w[1]) + (w[2] + w[3]));
    }
    add_to_corners<L>(sums, corner);
  }
  /// A component of a vector of which `values` are the particles' in memory, times mass.
  __attribute__((always_inline)) void add_momentum(double* sums, const Real* values) const {
    const ByRank momentum = load_by_rank(values + first_);
    Corners corner;
#pragma GCC unroll 4
    for (std::size_t n = 0; n < corner.size(); ++n) corner[n] = mass_ * sum_products(weights_[n], momentum);
    add_to_corners<L>(sums, corner);
  }
  /// A component of internal forces, of the parts that act across both axes. Slopes along one are weights along
  /// the other.
  __attribute__((always_inline)) void add_force(double* sums, const Real* across_x, const Real* across_y) const {
    const ByRank fx = load_by_rank(across_x + first_), fy = load_by_rank(across_y + first_);
    const Cells below = sum_products(from_y_, fx), above = sum_products(y_, fx);
    const Cells left = sum_products(from_x_, fy), right = sum_products(x_, fy);
    add_to_corners<L>(sums, {below + left, right - below, above - left, -above - right});
  }

 private:
  Real mass_;
  int first_;
  ByRank x_, y_, from_x_, from_y_, weights_[4];
};

/// Grid to a row's particles, as `gather`.
template <Layout L, class... Gathered>
__attribute__((always_inline)) inline void gather_row(const RealScratch& s, int first,
                                                      const Gathered&... gathered) {
  const ByRank x = load_by_rank(s.place[0].values + first), y = load_by_rank(s.place[1].values + first);
  const auto gather_one = [&](const auto& one) __attribute__((always_inline)) {
#pragma GCC unroll 2
    for (int a = 0; a < 2; ++a) {
      const Real* lower = s.window.data() + quantity(one.vector, a, 2) * L.window_nodes + s.cell[first];
      const Real* upper = lower + L.window_stride(1);
      const Cells left_below = load<Cells>(lower), below = load<Cells>(lower + 1) - left_below;
      const Cells left_above = load<Cells>(upper), above = load<Cells>(upper + 1) - left_above;
      std::array<ByRank, 3> sums;  // the value and its slopes
#pragma GCC unroll 4
      for (std::size_t k = 0; k < x.size(); ++k) {
        const Cells at_below = multiply_add(x[k], below, left_below);
        sums[2][k] = multiply_add(x[k], above, left_above) - at_below;
        sums[1][k] = multiply_add(y[k], above - below, below);
        sums[0][k] = multiply_add(y[k], sums[2][k], at_below);
      }
      for (ByRank& sum : sums) sum = in_order(sum);
#pragma GCC unroll 4
      for (std::size_t k = 0; k < x.size(); ++k) {
        const Cells of_particles[] = {sums[0][k], sums[1][k], sums[2][k]};
        one.put(first + cells_of_row * static_cast<int>(k), a, of_particles);
      }
    }
  };
  (gather_one(gathered), ...);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
