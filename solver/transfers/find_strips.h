#pragma once

#include "solver/transfers/runs.h"
#include "solver/transfers/strips.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The first cell of the eight that a strip has a lane for: its own first one, but so that all are in its row.
template <int Nodes, Layout L>
__attribute__((always_inline)) inline std::int32_t first_lane(std::int32_t cell) {
  constexpr std::int32_t last = L.window_side - (Nodes - 1) - cells_of_strip;
  static_assert(last >= 0);
  const std::int32_t row = RiseEnds<L.window_side>::row_of(cell) * L.window_side;
  return cell < row + last ? cell : row + last;
}

/// Lists strips if all are full, as they are inside bodies that have not been deformed much, and returns whether
/// they are.
inline bool list_full_strips(RealScratch& s, int particles) {
  constexpr EightLanes lane{0, 1, 2, 3, 4, 5, 6, 7};
  if (particles % cells_of_strip != 0) return false;
  const int count = particles / cells_of_strip;
  // Nodes beyond a row's last cell begin no stencil: what follows each other without a gap is in one row.
  EightLanes elsewhere{};
  for (int i = 0; i < count; ++i) {
    const std::int32_t *cell = s.cell + cells_of_strip * i, first = *cell;
    elsewhere |= load<EightLanes>(cell) ^ (lane + first);
    s.full_strips.begin[i] = cells_of_strip * i;
    s.full_strips.cell[i] = first;
  }
  if (any_bit(elsewhere)) return false;
  s.full_strips.size = count;
  s.sparse_strips.size = 0;
  return true;
}

/// A bit for each lane that has one of so many particles.
__attribute__((always_inline)) inline std::int32_t lanes_of_particles(const std::int32_t* cell, std::int32_t count,
                                                                      std::int32_t first) {
  constexpr EightLanes number{0, 1, 2, 3, 4, 5, 6, 7};
  const EightLanes at = load<EightLanes>(cell) - first, one = number - number + 1;
  return sum_of_lanes((one << (at & 7)) & (number < count));
}

template <int Nodes, Layout L>
inline void list_strips(RealScratch& s, const std::int32_t* rises, int count) {
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

/// Finds strips, or runs where those are fewer.
template <int Nodes, Layout L>
inline void find_strips(Block& block) {
  RealScratch& s = scratch_of(block);
  s.runs = 0;
  s.by_strips = list_full_strips(s, block.count);
  if (s.by_strips) return;
  std::int32_t rises[block_size + 16];
  const int count = 1 + find_ends<RiseEnds<L.window_side>>(s.cell, block.count, rises + 1);
  rises[0] = 0;
  rises[count] = block.count;
  // With more than two particles to a strip there is no need to ask.
  if (2 * count >= block.count) find_runs(block);
  s.by_strips = 2 * count < block.count || count < s.runs;
  if (!s.by_strips) return;
  s.runs = 0;
  list_strips<Nodes, L>(s, rises, count);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
