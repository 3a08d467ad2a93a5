#pragma once

#include "solver/executors/block.h"
#include "solver/executors/instruction_set.h"

/// Where particles are. They are ordered by cell: what is the same for a run of consecutive particles in one
/// cell is done once.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

typedef double Four __attribute__((vector_size(32)));
typedef double Pair __attribute__((vector_size(16)));

template <class Vector>
__attribute__((always_inline)) inline Vector load(const double* from) {
  Vector value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}
template <class Vector>
__attribute__((always_inline)) inline void store(double* to, Vector value) {
  __builtin_memcpy(to, &value, sizeof value);
}

/// Cell and place in it. A particle that is not where its tile allows is put to the nearest place that is,
/// so that what follows is harmless, and counted.
inline void locate(Block& block) {
  Scratch& s = *block.scratch;
  const SweepConstants& c = *block.sweep;
  const double* x = block[Attribute::position_x];
  const double* y = block[Attribute::position_y];
  const double below = 1 - 0x1p-40;
  const double x0 = block.lowest_x, x1 = block.highest_x + below;
  const double y0 = block.lowest_y, y1 = block.highest_y + below;
  std::int64_t left = 0;
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    const double cx = (x[i] - c.origin_x) * c.inverse_cell - block.window_x;
    const double cy = (y[i] - c.origin_y) * c.inverse_cell - block.window_y;
    const double ax = cx > x0 ? cx : x0;
    const double ay = cy > y0 ? cy : y0;
    const double bx = ax < x1 ? ax : x1;
    const double by = ay < y1 ? ay : y1;
    const int column = static_cast<int>(bx);
    const int row = static_cast<int>(by);
    left += (bx != cx) | (by != cy);
    s.cell[i] = row * window_side + column;
    s.fx[i] = bx - column;
    s.fy[i] = by - row;
  }
  s.trouble.left_window += left;
}

/// Calls of(begin, end, cell) for every run of consecutive particles in one cell.
template <class Function>
__attribute__((always_inline)) inline void for_each_run(const Block& block, Function&& of) {
  const std::int64_t* cell = block.scratch->cell;
  for (int begin = 0; begin < block.count;) {
    int end = begin + 1;
    while (end < block.count && cell[end] == cell[begin]) ++end;
    of(begin, end, cell[begin]);
    begin = end;
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
