#pragma once

#include "solver/transfers/find_places.h"
#include "solver/transfers/find_strips.h"
#include "solver/transfers/vectors.h"

/// The shape functions where particles are.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Whether the stencils of particles in a block reach beyond a face of the domain.
template <Reach reach>
inline bool reaches_a_face(const Block& block, int axis) {
  const double lower = -block.window_first[axis], upper = block.sweep->faces[axis] + lower;
  const bool faces = block.sweep->period[axis] == 0;
  return faces &&
         (block.lowest[axis] - more_below(reach) < lower || block.highest[axis] + 1 + more_above(reach) > upper);
}

/// Shape functions of nodes beyond a face of the domain do not exist: what they would carry is the linear
/// extrapolation of the two nodes before them. This makes the boundary functions of Steffen, Kirby and Berzins
/// (2008), interpolating on the face, and keeps the partition of unity and linear fields.
template <class Shape, bool with_slopes>
inline void fold(Block& block, int axis) {
  constexpr int Nodes = Shape::nodes;
  RealScratch& s = scratch_of(block);
  const double lower_face = -block.window_first[axis], upper_face = block.sweep->faces[axis] + lower_face;
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
  const double first = block.window_first[axis], lowest = block.lowest[axis] + begin_of_cells(Shape::reach),
               end = block.highest[axis] + 1 + begin_of_cells(Shape::reach);
  for (int i = 0; i < block.count; ++i) {
    // The stencil's first node, counted from the window's first cell.
    const double at = (x[i] - block.sweep->origin[axis]) * block.sweep->inverse_cell - first;
    const double clamped = at < lowest ? lowest : at > end ? end : at;
    const double base = __builtin_round(clamped - s.place[axis][i]);
    fold_row(s.weight[axis], i, base);
    if (with_slopes) fold_row(s.slope[axis], i, base);
  }
}

/// Weights of the stencil's nodes along one axis.
template <class Shape, bool with_slopes = true>
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
      if (with_slopes) s.slope[axis][n][i] = slope[n];
    }
  }
}

/// Without slopes where nothing that follows needs them: by quadratic B-splines in a plane 1 ns less per particle
/// and step.
template <class Shape, Layout L, bool with_slopes = true>
inline void locate(Block& block) {
  find_places<Shape, L>(block);
  if constexpr (has_strips<ProductStencil<Shape::nodes, L, ShapeSlopes>>)
    find_strips<Shape::nodes, L>(block);
  else
    find_runs(block);
  for (int axis = 0; axis < L.dimensions; ++axis) {
    // Two nodes' weights follow from the place alone.
    if constexpr (Shape::nodes > 2) weigh_along<Shape, with_slopes>(block, axis);
    if constexpr (Shape::folds)
      if (reaches_a_face<L.reach>(block, axis)) fold<Shape, with_slopes>(block, axis);
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
