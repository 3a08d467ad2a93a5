#pragma once

#include "solver/shapes/linear.h"
#include "solver/transfers/locate.h"
#include "solver/transfers/runs.h"

/// Bilinear shape functions of plane scenes by themselves: particles are ordered by cell, and what is the same
/// for a run of consecutive particles in one cell is done once.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

inline constexpr Layout plane_linear_layout{2, false};

/// Bilinear interpolation in the cell whose lower left node has index k:
/// base[k] + fx dx[k] + fy (dy[k] + fx dxy[k]), exact for a uniform field.
struct PlaneLinearValue {
  static constexpr int nodes = plane_linear_layout.window_nodes;
  static constexpr int copies = 4;
  const Real *base, *dx, *dy, *dxy;
  __attribute__((always_inline)) PlaneLinearValue(const Real* window, int which)
      : base(window + which * copies * nodes), dx(base + nodes), dy(dx + nodes), dxy(dy + nodes) {}
};

/// Cells and places in them, no weights.
inline void locate_in_cells(Block& block) {
  locate_along<Linear, plane_linear_layout>(block, 0);
  locate_along<Linear, plane_linear_layout>(block, 1);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
