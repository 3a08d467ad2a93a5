#pragma once

#include "solver/transfers/strips.h"

/// Strips and nodes along both axes.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The shape functions of a strip's particles along one axis.
template <int Nodes>
struct AlongAxis {
  template <class OneStrip>
  __attribute__((always_inline)) AlongAxis(const RealScratch& s, int axis, const OneStrip& strip) {
    if constexpr (Nodes == 2) {
      weight[1] = strip.load(s.place[axis].values);
      weight[0] = 1 - weight[1];
    } else {
#pragma GCC unroll 4
      for (int n = 0; n < Nodes; ++n) weight[n] = strip.load(s.weight[axis][n].values);
    }
  }
  Cells weight[Nodes];
};

/// What the nodes get of one quantity, [row][along x], each lane by the cell of which they are that node.
template <int Nodes, Layout L>
struct NodesOfStrips {
  Cells node[Nodes][Nodes] = {};

  /// Adds it to `to`, which is the first cell's first node.
  __attribute__((always_inline)) void add_to(double* to) const {
#pragma GCC unroll 4
    for (int j = 0; j < Nodes; ++j) add_row(j, to + j * L.window_stride(1));
  }
  /// Adds the first row to `to`. What is left is the beginning of what nodes get of the next row of cells.
  __attribute__((always_inline)) void add_first_row(double* to) {
    add_row(0, to);
#pragma GCC unroll 4
    for (int j = 0; j < Nodes; ++j)
#pragma GCC unroll 4
      for (int i = 0; i < Nodes; ++i) node[j][i] = j + 1 < Nodes ? node[j + 1][i] : Cells{};
  }

 private:
  using Beyond = VectorOf<float, 4>::Type;

  __attribute__((always_inline)) void add_row(int j, double* to) const {
    Cells sum = node[j][0];
    Beyond beyond{};
    add_shifted<1>(node[j], sum, beyond);
    add(to, sum);
    if constexpr (Nodes == 2)
      to[cells_of_strip] += static_cast<double>(beyond[0]);
    else
      add(to + cells_of_strip, beyond);
  }

  /// The numbers of cells so many before, and of the last ones those that are beyond the eighth.
  template <int by>
  __attribute__((always_inline)) static void add_shifted(const Cells (&of)[Nodes], Cells& sum, Beyond& beyond) {
    if constexpr (by < Nodes) {
      const Cells none{};
      sum += __builtin_shufflevector(none, of[by], 8 - by, 9 - by, 10 - by, 11 - by, 12 - by, 13 - by, 14 - by,
                                     15 - by);
      beyond += __builtin_shufflevector(of[by], none, 8 - by, 9 - by, 10 - by, 11 - by);
      add_shifted<by + 1>(of, sum, beyond);
    }
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
