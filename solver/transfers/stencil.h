#pragma once

#include <type_traits>

#include "solver/transfers/real.h"
#include "solver/transfers/vectors.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Where a stencil finds the factors of its slopes.
struct ShapeSlopes {
  static const RealArray* along(const RealScratch& s, int axis) { return s.slope[axis]; }
};

/// The shape functions of one particle that are products along the axes, a row of nodes along x at a time.
/// Three nodes are a row of four whose last one has no weight.
template <int Nodes, Layout L, class Slopes = ShapeSlopes>
struct ProductStencil {
  static constexpr int D = L.dimensions;
  static constexpr int rows = D == 1 ? 1 : D == 2 ? Nodes : Nodes * Nodes;
  using Row = Four;

  __attribute__((always_inline)) ProductStencil(const RealScratch& s, int i) : scratch(s), particle(i) {
    weight_x = row(s.weight[0]);
    slope_x = row(Slopes::along(s, 0));
  }

  /// Which node of its row a lane is.
  static constexpr int offset(int lane) { return lane; }
  __attribute__((always_inline)) static void add_row(double* to, Row row) { add(to, row); }

  /// Calls of(index of the row's first node from the stencil's first one, weights, slopes[D]).
  template <class Function>
  __attribute__((always_inline)) void for_each_row(Function&& of) const {
    if constexpr (D == 1) {
      const Row slopes[1] = {slope_x};
      of(0, weight_x, slopes);
    } else if constexpr (D == 2) {
#pragma GCC unroll 4
      for (int j = 0; j < Nodes; ++j) {
        const Real w = scratch.weight[1][j].values[particle];
        const Row slopes[2] = {slope_x * w, weight_x * Slopes::along(scratch, 1)[j].values[particle]};
        of(j * L.window_stride(1), weight_x * w, slopes);
      }
    } else {
#pragma GCC unroll 4
      for (int k = 0; k < Nodes; ++k) {
        const Real wz = scratch.weight[2][k].values[particle], dz = Slopes::along(scratch, 2)[k].values[particle];
#pragma GCC unroll 4
        for (int j = 0; j < Nodes; ++j) {
          const Real wy = scratch.weight[1][j].values[particle],
                     dy = Slopes::along(scratch, 1)[j].values[particle];
          const Row slopes[3] = {slope_x * (wy * wz), weight_x * (dy * wz), weight_x * (wy * dz)};
          of(j * L.window_stride(1) + k * L.window_stride(2), weight_x * (wy * wz), slopes);
        }
      }
    }
  }

 private:
  __attribute__((always_inline)) Row row(const RealArray* values) const {
    Row r{};
    for (int n = 0; n < Nodes; ++n) r[n] = values[n].values[particle];
    return r;
  }

  const RealScratch& scratch;
  int particle;
  Row weight_x, slope_x;
};

/// Two nodes along each axis: all corners of a cell are one row.
template <Layout L, class Slopes>
struct ProductStencil<2, L, Slopes> {
  static constexpr int D = L.dimensions, rows = 1;
  using Row = std::conditional_t<D == 1, Pair, std::conditional_t<D == 2, Four, Eight>>;

  __attribute__((always_inline)) ProductStencil(const RealScratch& s, int i) {
#pragma GCC unroll 3
    for (int axis = 0; axis < D; ++axis) {
      const Row place = spread<Row>(s.place[axis].values[i]);
      factor[axis] = multiply_add(along(axis, -1, 1), place, along(axis, 1, 0));
      if constexpr (std::is_same_v<Slopes, ShapeSlopes>)
        slope[axis] = along(axis, -1, 1);
      else
        slope[axis] = along(axis, Slopes::along(s, axis)[0].values[i], Slopes::along(s, axis)[1].values[i]);
    }
  }

  static constexpr int offset(int lane) {
    int sum = 0;
    for (int axis = 0; axis < D; ++axis) sum += (lane >> axis & 1) * L.window_stride(axis);
    return sum;
  }
  __attribute__((always_inline)) static void add_row(double* to, Row row) {
#pragma GCC unroll 4
    for (int lane = 0; lane < 1 << D; lane += 2) add(to + offset(lane), Pair{row[lane], row[lane + 1]});
  }

  template <class Function>
  __attribute__((always_inline)) void for_each_row(Function&& of) const {
    if constexpr (D == 1) {
      of(0, factor[0], slope);
    } else if constexpr (D == 2) {
      const Row slopes[2] = {slope[0] * factor[1], factor[0] * slope[1]};
      of(0, factor[0] * factor[1], slopes);
    } else {
      const Row xy = factor[0] * factor[1];
      const Row slopes[3] = {slope[0] * (factor[1] * factor[2]), slope[1] * (factor[0] * factor[2]),
                             slope[2] * xy};
      of(0, xy * factor[2], slopes);
    }
  }

 private:
  /// One value for the lower corners along an axis, one for the upper ones.
  __attribute__((always_inline)) static Row along(int axis, Real lower, Real upper) {
    Row row;
#pragma GCC unroll 8
    for (int lane = 0; lane < 1 << D; ++lane) row[lane] = lane >> axis & 1 ? upper : lower;
    return row;
  }

  Row factor[D], slope[D];
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
