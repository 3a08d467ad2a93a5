#pragma once

#include <cstdint>
#include <type_traits>

#include "solver/transfers/eight_lanes.h"
#include "solver/transfers/runs.h"
#include "solver/transfers/stencil.h"

/// Strips: up to eight particles, one after the other, that are in ever higher ones of eight neighbouring cells of
/// a row. Each cell is a lane, so that particles that share nodes never meet before their sums do. In a plane and
/// in floats particles are put in such an order (`sort_into_tiles`): first ones of all cells of a row, then the
/// second ones, and so on. They may drift: a strip ends where its cells no longer grow.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Whether particles are worked on so.
template <class Stencil>
inline constexpr bool has_strips = false;
#ifdef __AVX2__
template <int Nodes, Layout L>
inline constexpr bool has_strips<ProductStencil<Nodes, L, ShapeSlopes>> =
    L.dimensions == 2 && std::is_same_v<Real, float>;
#endif

/// A number of each cell of a strip.
using Cells = VectorOf<float, 8>::Type;
inline constexpr int cells_of_strip = 8;

/// The first cell of the eight that a strip has a lane for: its own first one, but so that all are in its row.
template <int Nodes, Layout L>
inline std::int32_t first_lane(std::int32_t cell) {
  constexpr std::int32_t last = L.window_side - (Nodes - 1) - cells_of_strip;
  static_assert(last >= 0);
  const std::int32_t row = cell / L.window_side * L.window_side;
  return cell < row + last ? cell : row + last;
}

/// A bit for each lane that has one of so many particles.
__attribute__((always_inline)) inline std::int32_t lanes_of_particles(const std::int32_t* cell, std::int32_t count,
                                                                      std::int32_t first) {
  constexpr EightLanes number{0, 1, 2, 3, 4, 5, 6, 7};
  const EightLanes at = load<EightLanes>(cell) - first, one = number - number + 1;
  return sum_of_lanes((one << (at & 7)) & (number < count));
}

/// Finds strips, or runs where those are fewer.
template <int Nodes, Layout L>
inline void find_strips(Block& block) {
  RealScratch& s = scratch_of(block);
  std::int32_t rises[block_size + 16];
  const int count = 1 + find_ends<RiseEnds<L.window_side>>(s.cell, block.count, rises + 1);
  rises[0] = 0;
  rises[count] = block.count;
  // With more than two particles to a strip there is no need to ask.
  s.by_strips = 2 * count < block.count;
  if (!s.by_strips) find_runs(block);
  s.by_strips = s.by_strips || count < s.runs;
  if (!s.by_strips) return;
  s.runs = 0;
  auto& full = s.full_strips;
  auto& sparse = s.sparse_strips;
  int full_ones = 0, sparse_ones = 0;
  for (int rise = 0; rise < count; ++rise)
    for (std::int32_t begin = rises[rise], end; begin < rises[rise + 1]; begin = end) {
      end = rises[rise + 1];
      const std::int32_t first = first_lane<Nodes, L>(s.cell[begin]);
      while (s.cell[end - 1] - first >= cells_of_strip) --end;
      // To both lists, one of which forgets it: a processor would guess wrong which it is.
      full.begin[full_ones] = sparse.begin[sparse_ones] = begin;
      full.cell[full_ones] = sparse.cell[sparse_ones] = first;
      sparse.count[sparse_ones] = end - begin;
      const bool is_full = end - begin == cells_of_strip;
      full_ones += is_full;
      sparse_ones += !is_full;
    }
  for (int i = 0; i < sparse_ones; ++i)
    sparse.lanes[i] = lanes_of_particles(s.cell + sparse.begin[i], sparse.count[i], sparse.cell[i]);
  full.size = full_ones;
  sparse.size = sparse_ones;
}

/// A strip that has a particle in every cell.
class FullStrip {
 public:
  FullStrip(const RealScratch& s, int strip)
      : first_(s.full_strips.begin[strip]), cell_(s.full_strips.cell[strip]) {}
  static const auto& list(const RealScratch& s) { return s.full_strips; }
  int first() const { return first_; }
  int cell() const { return cell_; }  ///< the first one that has a lane
  /// Of its particles, by cell.
  __attribute__((always_inline)) Cells load(const float* values) const {
    return trajan::load<Cells>(values + first_);
  }
  /// Without those of cells that have none.
  __attribute__((always_inline)) Cells only_there(Cells cells) const { return cells; }
  /// What cells have, by particle.
  __attribute__((always_inline)) Cells in_order(Cells cells) const { return cells; }

 private:
  int first_, cell_;
};

/// Any other one: the particles' lanes are found by permutations.
class SparseStrip {
 public:
  SparseStrip(const RealScratch& s, int strip)
      : first_(s.sparse_strips.begin[strip]),
        cell_(s.sparse_strips.cell[strip]),
        particle_(count_lanes_before(s.sparse_strips.lanes[strip])),
        particles_(lanes_of((1 << s.sparse_strips.count[strip]) - 1)),
        lane_(trajan::load<EightLanes>(s.cell + first_) - cell_),
        there_(lanes_of(s.sparse_strips.lanes[strip])) {}
  static const auto& list(const RealScratch& s) { return s.sparse_strips; }
  int first() const { return first_; }
  int cell() const { return cell_; }
  __attribute__((always_inline)) Cells load(const float* values) const {
    return only_there(permuted(load_only(values + first_, particles_), particle_));
  }
  __attribute__((always_inline)) Cells only_there(Cells cells) const { return there_ ? cells : Cells{}; }
  __attribute__((always_inline)) Cells in_order(Cells cells) const { return permuted(cells, lane_); }

 private:
  int first_, cell_;
  EightLanes particle_, particles_, lane_, there_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
