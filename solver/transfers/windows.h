#pragma once

#include "solver/executors/tiles.h"
#include "solver/transfers/vectors.h"

/// Between tiles and windows. Sums are taken over the tiles around in a fixed order, so that their bits do
/// not depend on which thread does what.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The part of a tile that lies in the window of a neighbour, along one axis: nodes begin .. end - 1 of the
/// tile are nodes begin + shift .. of the neighbour's window.
struct Overlap {
  int begin, end, shift;
  constexpr Overlap(const Layout& layout, int offset)
      : begin(offset > 0 ? layout.side - layout.below : 0),
        end(offset < 0 ? layout.above : layout.side),
        shift(layout.below - offset * layout.side) {}
};

/// Adds one quantity of all windows around to `out`, which has tile_nodes entries.
template <Layout L>
inline void collect(const Neighbours& sums, int which, double* __restrict out) {
  constexpr int D = L.dimensions;
  for (int i = 0; i < tile_nodes; ++i) out[i] = 0;
  for (int n = 0; n < L.neighbours; ++n) {
    const double* from = sums[n] + which * L.window_nodes;
    const Overlap x(L, n % 3 - 1), y(L, n / 3 % 3 - 1), z(L, n / 9 - 1);
    for (int k = D > 2 ? z.begin : 0; k < (D > 2 ? z.end : 1); ++k)
      for (int j = D > 1 ? y.begin : 0; j < (D > 1 ? y.end : 1); ++j) {
        const double* row = from + x.shift;
        if constexpr (D > 1) row += (j + y.shift) * L.window_stride(1);
        if constexpr (D > 2) row += (k + z.shift) * L.window_stride(2);
        double* to = out + j * L.tile_stride(1) + k * L.tile_stride(2);
        for (int i = x.begin; i < x.end; ++i) to[i] += row[i];
      }
  }
}

/// As above. Of the window of the tile to the left, columns 9 and 10 are this tile's columns 0 and 1, of the
/// one to the right column 0 is this tile's column 7; rows likewise.
template <>
inline void collect<Layout{2, false}>(const Neighbours& sums, int which, double* __restrict out) {
  constexpr Layout layout{2, false};
  constexpr int side = layout.side;
  const auto add_row = [&](int n, int row, Eight sum) __attribute__((always_inline)) {
    const int at = which * layout.window_nodes + row * layout.window_side;
    const double* left = sums[n] + at;
    const double* right = sums[n + 2] + at;
    sum += Eight{left[side + 1], left[side + 2], 0, 0, 0, 0, 0, 0};
    sum += load<Eight>(sums[n + 1] + at + 1);
    sum += Eight{0, 0, 0, 0, 0, 0, 0, right[0]};
    return sum;
  };
  for (int j = 0; j < side; ++j) {
    Eight sum{};
    if (j < 2) sum = add_row(0, j + side + 1, sum);
    sum = add_row(3, j + 1, sum);
    if (j == side - 1) sum = add_row(6, 0, sum);
    store(out + j * side, sum);
  }
}

/// Copies what a tile and its neighbours hold into a window. `mask`: bits of the quantities.
template <Layout L>
inline void load_window(double* window, const Neighbours& nodes, unsigned mask) {
  constexpr int D = L.dimensions;
  for (int q = 0; mask >> q; ++q) {
    if (!(mask >> q & 1u)) continue;
    for (int n = 0; n < L.neighbours; ++n) {
      const double* from = nodes[n] + q * tile_nodes;
      // Seen from the neighbour, this tile lies on the other side.
      const int side_x = n % 3 - 1, side_y = n / 3 % 3 - 1, side_z = n / 9 - 1;
      const auto first = [](int s) { return s > 0 ? L.below + L.side : s < 0 ? 0 : L.below; };
      const auto count = [](int s) { return s > 0 ? L.above : s < 0 ? L.below : L.side; };
      const auto source = [](int s) { return s < 0 ? L.side - L.below : 0; };
      for (int k = 0; k < (D > 2 ? count(side_z) : 1); ++k)
        for (int j = 0; j < (D > 1 ? count(side_y) : 1); ++j) {
          const double* row = from + source(side_x);
          double* to = window + q * L.window_nodes + first(side_x);
          if constexpr (D > 1) {
            row += (source(side_y) + j) * L.tile_stride(1);
            to += (first(side_y) + j) * L.window_stride(1);
          }
          if constexpr (D > 2) {
            row += (source(side_z) + k) * L.tile_stride(2);
            to += (first(side_z) + k) * L.window_stride(2);
          }
          for (int i = 0; i < count(side_x); ++i) to[i] = row[i];
        }
    }
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
