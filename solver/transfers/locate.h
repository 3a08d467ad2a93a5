#pragma once

#include "solver/transfers/real.h"
#include "solver/transfers/vectors.h"

/// Where particles are: the first node of each one's stencil, and the shape functions there.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Along one axis: adds the first node to the index of the stencil's and keeps the place in the stencil. A
/// particle that is not where its tile allows is put to the nearest place that is, so that what follows is
/// harmless, and counted.
template <class Shape, Layout L>
inline void locate_along(Block& block, int axis) {
  RealScratch& s = scratch_of(block);
  const SweepConstants& c = *block.sweep;
  const double* x = block.component(Attribute::position_x, axis);
  const double below = 1 - 0x1p-40, lowest = block.lowest[axis], highest = block.highest[axis] + below;
  const double origin = c.origin[axis], inverse_cell = c.inverse_cell, first = block.window_first[axis];
  const double period = c.period[axis];
  const int stride = L.window_stride(axis);
  Real* place = s.place[axis].data();
  std::int64_t left = 0;
  const auto locate_each = [&](auto in_window) __attribute__((always_inline)) {
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) {
      const double at = in_window((x[i] - origin) * inverse_cell - first);
      const double not_below = at > lowest ? at : lowest;
      const double inside = not_below < highest ? not_below : highest;
      left += inside != at;
      const double node = inside + (L.below - 1);
      const int base = Shape::first_node(node);
      s.cell[i] = (axis == 0 ? 0 : s.cell[i]) + base * stride;
      place[i] = Real(node - base);
    }
  };
  if (period > 0)
    locate_each([=](double at) { return at - period * __builtin_floor((at - lowest) / period); });
  else
    locate_each([](double at) { return at; });
  s.trouble.left_window += left;
}

/// Shape functions of nodes beyond a face of the domain do not exist: what they would carry is the linear
/// extrapolation of the two nodes before them. This makes the boundary functions of Steffen, Kirby and Berzins
/// (2008), interpolating on the face, and keeps the partition of unity and linear fields.
template <int Nodes>
inline void fold(Block& block, int axis, double lower_face, double upper_face) {
  RealScratch& s = scratch_of(block);
  const auto fold_row = [&](RealArray * w, int i, double base) __attribute__((always_inline)) {
    for (int n = 0; n + 2 < Nodes; ++n) {
      const Real beyond = base + n < lower_face ? w[n][i] : Real(0);
      w[n][i] -= beyond;
      w[n + 1][i] += 2 * beyond;
      w[n + 2][i] -= beyond;
    }
    for (int n = Nodes - 1; n >= 2; --n) {
      const Real beyond = base + n > upper_face ? w[n][i] : Real(0);
      w[n][i] -= beyond;
      w[n - 1][i] += 2 * beyond;
      w[n - 2][i] -= beyond;
    }
  };
  const double* x = block.component(Attribute::position_x, axis);
  const double first = block.window_first[axis];
  for (int i = 0; i < block.count; ++i) {
    // The stencil's first node, counted from the window's first cell.
    const double at = (x[i] - block.sweep->origin[axis]) * block.sweep->inverse_cell - first;
    const double clamped = at < block.lowest[axis]        ? block.lowest[axis]
                           : at > block.highest[axis] + 1 ? block.highest[axis] + 1
                                                          : at;
    const double base = __builtin_round(clamped - s.place[axis][i]);
    fold_row(s.weight[axis], i, base);
    fold_row(s.slope[axis], i, base);
  }
}

/// Weights of the stencil's nodes along one axis.
template <class Shape>
inline void weigh_along(Block& block, int axis) {
  RealScratch& s = scratch_of(block);
  const Real half_size = Real(block.body->half_size[axis]);
  const Real* place = s.place[axis].data();
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    Real weight[Shape::nodes], slope[Shape::nodes];
    Shape::weigh(place[i], Shape::needs_deformation ? half_size * deformation_of(block, axis, axis, i) : half_size,
                 weight, slope);
    for (int n = 0; n < Shape::nodes; ++n) {
      s.weight[axis][n][i] = weight[n];
      s.slope[axis][n][i] = slope[n];
    }
  }
}

template <class Shape, Layout L>
inline void locate(Block& block) {
  for (int axis = 0; axis < L.dimensions; ++axis) {
    locate_along<Shape, L>(block, axis);
    // Two nodes' weights follow from the place alone.
    if constexpr (Shape::nodes > 2) weigh_along<Shape>(block, axis);
    if constexpr (Shape::folds) {
      const double lower = -block.window_first[axis], upper = block.sweep->faces[axis] + lower;
      const bool faces = block.sweep->period[axis] == 0;
      if (faces && (block.lowest[axis] - 1 <= lower || block.highest[axis] + 2 >= upper))
        fold<Shape::nodes>(block, axis, lower, upper);
    }
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
