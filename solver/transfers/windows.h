#pragma once

#include "solver/executors/tiles.h"
#include "solver/transfers/masks.h"
#include "solver/transfers/real.h"
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

/// A tile's nodes along x.
template <Layout L>
using TileRow = Numbers<double, static_cast<std::size_t>(L.side)>;

/// What a row of nodes gets of the windows of its tile (`middle`) and of those to the left and right; each points
/// at the window's row.
template <Layout L>
__attribute__((always_inline)) inline TileRow<L> add_row(const double* left, const double* middle,
                                                         const double* right, TileRow<L> sum) {
  constexpr int side = L.side;
  auto outer = load_lanes<TileRow<L>, 0, L.above>(left + L.below + side);
  if constexpr (L.below > 0) outer += load_lanes<TileRow<L>, side - L.below, side>(right - (side - L.below));
  return sum + load<TileRow<L>>(middle + L.below) + outer;
}

/// Adds one quantity of all windows around to `out`, which has tile_nodes entries.
template <Layout L>
inline void collect(const Neighbours& sums, int which, double* __restrict out) {
  const auto covers = [](int at, int offset) {
    return at >= Overlap(L, offset).begin && at < Overlap(L, offset).end;
  };
  for (int k = 0; k < (L.dimensions > 2 ? L.side : 1); ++k)
    for (int j = 0; j < L.side; ++j) {
      TileRow<L> sum{};
      for (int z = L.dimensions > 2 ? -1 : 0; z <= (L.dimensions > 2 ? 1 : 0); ++z) {
        if (L.dimensions > 2 && !covers(k, z)) continue;
        for (int y = -1; y <= 1; ++y) {
          if (!covers(j, y)) continue;
          const double* const* from = &sums[(L.dimensions > 2 ? 9 * (z + 1) : 0) + 3 * (y + 1)];
          int row = (j + Overlap(L, y).shift) * L.window_stride(1);
          if (L.dimensions > 2) row += (k + Overlap(L, z).shift) * L.window_stride(2);
          const std::ptrdiff_t at = L.window_array(which) + row;
          sum = add_row<L>(from[0] + at, from[1] + at, from[2] + at, sum);
        }
      }
      const int row = j * L.tile_stride(1) + k * L.tile_stride(2);
      store(out + row, sum);
    }
}

template <Layout L>
requires(L.dimensions == 1) inline void collect(const Neighbours& sums, int which, double* __restrict out) {
  for (int i = 0; i < tile_nodes; ++i) out[i] = 0;
  for (int n = 0; n < L.neighbours; ++n) {
    const Overlap x(L, n - 1);
    const double* row = sums[n] + L.window_array(which) + x.shift;
    for (int i = x.begin; i < x.end; ++i) out[i] += row[i];
  }
}

/// Along one axis: which of three tiles a row of a window's nodes belongs to, and which of its rows that is.
struct RowOfTile {
  int tile, row;
  constexpr RowOfTile(const Layout& layout, int window_row)
      : tile((window_row - layout.below + layout.side) / layout.side),
        row((window_row - layout.below + layout.side) % layout.side) {}
};

/// Copies what a tile and its neighbours hold into a window. `mask`: bits of the quantities.
template <Layout L>
inline void load_window(Scratch& scratch, const Neighbours& nodes, unsigned mask) {
  Real* window = static_cast<RealScratch&>(scratch).window.data();
  constexpr int D = L.dimensions, side = L.side;
  for (int q = 0; mask >> q; ++q) {
    if (!(mask >> q & 1u)) continue;
    Real* to = window + L.window_array(q);
    for (int k = 0; k < (D > 2 ? L.window_side : 1); ++k)
      for (int j = 0; j < (D > 1 ? L.window_side : 1); ++j, to += L.window_side) {
        const RowOfTile y(L, j), z(L, k);
        const double* const* from = &nodes[(D > 2 ? 9 * z.tile : 0) + (D > 1 ? 3 * y.tile : 0)];
        int row = 0;
        if constexpr (D > 1) row += y.row * L.tile_stride(1);
        if constexpr (D > 2) row += z.row * L.tile_stride(2);
        const std::ptrdiff_t at = tile_array(q) + row;
        for (int i = 0; i < L.below; ++i) to[i] = Real(from[0][at + side - L.below + i]);
        if constexpr (D > 1) {
          store(to + L.below, load<TileRow<L>>(from[1] + at));
          // Too many, of which the next row or what a window has to spare gets the last.
          store(to + L.below + side, load<VectorOf<double, 4>::Type>(from[2] + at));
        } else {
          for (int i = 0; i < side; ++i) to[L.below + i] = Real(from[1][at + i]);
          for (int i = 0; i < L.above; ++i) to[L.below + side + i] = Real(from[2][at + i]);
        }
      }
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
