#include "solver/implicit/stencil_kernels.h"

#include <cmath>

#include "solver/shapes/shapes.h"
#include "solver/surfaces/spline_faces.h"
#include "solver/transfers/corner_stencil.h"

namespace trajan {
namespace {

template <class Stencil, Layout L, Stage Locate>
void append(Block& block, BlockStencils& out) {
  constexpr int D = L.dimensions, lanes = sizeof(typename Stencil::Row) / sizeof(double);
  Locate(block);
  const RealScratch& scratch = scratch_of(block);
  for (int i = 0; i < block.count; ++i) {
    const std::size_t before = out.nodes.size();
    const RowParticles<1> particle{i};
    Stencil(scratch, particle).for_each_row(particle, [&](int at, auto weights, const auto* slopes) {
      for (int lane = 0; lane < lanes; ++lane) {
        bool any = weights[lane] != 0;
        for (int axis = 0; axis < D; ++axis) any = any || slopes[axis][lane] != 0;
        if (!any) continue;
        out.nodes.push_back(scratch.cell[i] + at + Stencil::offset(lane));
        out.weights.push_back(weights[lane]);
        for (int axis = 0; axis < D; ++axis)
          out.gradients.push_back(slopes[axis][lane] * block.sweep->inverse_cell);
      }
    });
    out.counts.push_back(static_cast<int>(out.nodes.size() - before));
  }
}

/// As `locate`, with splines that keep their degree up to faces of the domain. Particles are sorted.
template <class Shape, Layout L>
void locate_to_faces(Block& block) {
  RealScratch& s = scratch_of(block);
  const SweepConstants& c = *block.sweep;
  const PointFunctions& functions = point_functions(Shape::name);
  find_places<Shape, L>(block);
  for (int axis = 0; axis < L.dimensions; ++axis) {
    if (c.period[axis] > 0) {
      weigh_along<Shape>(block, axis);
      continue;
    }
    const double* x = block.component(Attribute::position_x, axis);
    const double window = block.window_first[axis] - (L.below - 1);
    const SplineFaces faces{-window, c.faces[axis] - window};
    for (int i = 0; i < block.count; ++i) {
      double& place = s.place[axis][i];
      const double node = (x[i] - c.origin[axis]) * c.inverse_cell - window;
      const int first = static_cast<int>(std::lround(node - place)), inside = faces.inside(first, functions);
      s.cell[i] += (inside - first) * L.window_stride(axis);
      place -= inside - first;
      double weight[Shape::nodes], slope[Shape::nodes];
      faces.weigh(functions, inside, place, weight, slope);
      for (int n = 0; n < Shape::nodes; ++n) {
        s.weight[axis][n][i] = weight[n];
        s.slope[axis][n][i] = slope[n];
      }
    }
  }
}

template <class Shape>
constexpr bool by_corners = requires {
  requires Shape::corners;
};

template <class Shape, int D>
constexpr StencilKernel kernel(bool to_faces) {
  if constexpr (by_corners<Shape>) {
    constexpr Layout layout{D, Reach::wide};
    return &append<CornerStencil<layout>, layout, &locate_corners<Shape, layout>>;
  } else {
    constexpr Layout layout{D, Shape::reach};
    using Stencil = ProductStencil<Shape::nodes, layout, ShapeSlopes>;
    if constexpr (Shape::folds && polynomial_degree(Shape::name) > 1)
      if (to_faces) return &append<Stencil, layout, &locate_to_faces<Shape, layout>>;
    return &append<Stencil, layout, &locate<Shape, layout>>;
  }
}

}  // namespace

StencilKernel stencil_kernel(std::string_view shape_functions, Dimension dimension, bool to_faces) {
  const int axes = grid_axes(dimension);
#define TRAJAN_STENCIL(Shape)                       \
  if (Shape::name == shape_functions)               \
    return axes == 1   ? kernel<Shape, 1>(to_faces) \
           : axes == 2 ? kernel<Shape, 2>(to_faces) \
                       : kernel<Shape, 3>(to_faces);
  TRAJAN_FOR_EACH_SHAPE_CLASS(TRAJAN_STENCIL)
#undef TRAJAN_STENCIL
  return nullptr;
}

}  // namespace trajan
