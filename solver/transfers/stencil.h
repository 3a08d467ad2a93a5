#pragma once

#include <type_traits>

#include "solver/executors/block.h"
#include "solver/transfers/vectors.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Where a stencil finds the factors of its slopes.
struct ShapeSlopes {
  static const BlockArray* along(const Scratch& s, int axis) { return s.slope[axis]; }
};

/// The shape functions of one particle that are products along the axes, a row of nodes along x at a time.
/// Three nodes are a row of four whose last one has no weight.
template <int Nodes, Layout L, class Slopes = ShapeSlopes>
struct ProductStencil {
  static constexpr int D = L.dimensions;
  using Row = std::conditional_t<Nodes == 2, Pair, Four>;

  __attribute__((always_inline)) ProductStencil(const Scratch& s, int i) : scratch(s), particle(i) {
    weight_x = row(s.weight[0]);
    slope_x = row(Slopes::along(s, 0));
  }

  /// Calls of(index of the row's first node from the stencil's first one, weights, slopes[D]).
  template <class Function>
  __attribute__((always_inline)) void for_each_row(Function&& of) const {
    if constexpr (D == 1) {
      const Row slopes[1] = {slope_x};
      of(0, weight_x, slopes);
    } else if constexpr (D == 2) {
#pragma GCC unroll 4
      for (int j = 0; j < Nodes; ++j) {
        const double w = scratch.weight[1][j].values[particle];
        const Row slopes[2] = {slope_x * w, weight_x * Slopes::along(scratch, 1)[j].values[particle]};
        of(j * L.window_stride(1), weight_x * w, slopes);
      }
    } else {
#pragma GCC unroll 4
      for (int k = 0; k < Nodes; ++k) {
        const double wz = scratch.weight[2][k].values[particle],
                     dz = Slopes::along(scratch, 2)[k].values[particle];
#pragma GCC unroll 4
        for (int j = 0; j < Nodes; ++j) {
          const double wy = scratch.weight[1][j].values[particle],
                       dy = Slopes::along(scratch, 1)[j].values[particle];
          const Row slopes[3] = {slope_x * (wy * wz), weight_x * (dy * wz), weight_x * (wy * dz)};
          of(j * L.window_stride(1) + k * L.window_stride(2), weight_x * (wy * wz), slopes);
        }
      }
    }
  }

 private:
  __attribute__((always_inline)) Row row(const BlockArray* values) const {
    Row r{};
    for (int n = 0; n < Nodes; ++n) r[n] = values[n].values[particle];
    return r;
  }

  const Scratch& scratch;
  int particle;
  Row weight_x, slope_x;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
