#pragma once

#include "solver/transfers/real.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Along one axis: what is needed to find places.
struct AxisPlaces {
  const double* x;
  Real* place;
  double origin, first;    ///< of what counts places in cells
  double lowest, highest;  ///< where the first and the last cell begin in which particles may be
  double period, divisor;
};

template <Layout L>
__attribute__((always_inline)) inline AxisPlaces axis_places(const Block& block, int axis) {
  const double to_nodes = L.below - 1, period = block.sweep->period[axis];
  return {.x = block.component(Attribute::position_x, axis),
          .place = scratch_of(block).place[axis].data(),
          .origin = block.sweep->origin[axis],
          .first = block.window_first[axis] - to_nodes,
          .lowest = block.lowest[axis] + to_nodes + begin_of_cells(L.reach),
          .highest = block.highest[axis] + to_nodes + begin_of_cells(L.reach),
          .period = period,
          .divisor = period > 0 ? period : 1};
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
