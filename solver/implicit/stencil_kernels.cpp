#include "solver/implicit/stencil_kernels.h"

#include "solver/shapes/shapes.h"
#include "solver/transfers/corner_stencil.h"

namespace trajan {
namespace {

template <class Stencil, Layout L, Stage Locate>
void append(Block& block, BlockStencils& out) {
  constexpr int D = L.dimensions, lanes = sizeof(typename Stencil::Row) / sizeof(double);
  Locate(block);
  const Scratch& scratch = *block.scratch;
  for (int i = 0; i < block.count; ++i) {
    const std::size_t before = out.nodes.size();
    Stencil(scratch, i).for_each_row([&](int at, auto weights, const auto* slopes) {
      for (int lane = 0; lane < lanes; ++lane) {
        bool any = weights[lane] != 0;
        for (int axis = 0; axis < D; ++axis) any = any || slopes[axis][lane] != 0;
        if (!any) continue;
        out.nodes.push_back(static_cast<int>(scratch.cell[i]) + at + Stencil::offset(lane));
        out.weights.push_back(weights[lane]);
        for (int axis = 0; axis < D; ++axis)
          out.gradients.push_back(slopes[axis][lane] * block.sweep->inverse_cell);
      }
    });
    out.counts.push_back(static_cast<int>(out.nodes.size() - before));
  }
}

template <class Shape>
constexpr bool by_corners = requires {
  requires Shape::corners;
};

template <class Shape, int D>
constexpr StencilKernel kernel() {
  if constexpr (by_corners<Shape>) {
    constexpr Layout layout{D, true};
    return &append<CornerStencil<layout>, layout, &locate_corners<Shape, layout>>;
  } else {
    constexpr Layout layout{D, Shape::wide};
    return &append<ProductStencil<Shape::nodes, layout>, layout, &locate<Shape, layout>>;
  }
}

}  // namespace

StencilKernel stencil_kernel(std::string_view shape_functions, Dimension dimension) {
  const int axes = grid_axes(dimension);
#define TRAJAN_STENCIL(Shape)         \
  if (Shape::name == shape_functions) \
    return axes == 1 ? kernel<Shape, 1>() : axes == 2 ? kernel<Shape, 2>() : kernel<Shape, 3>();
  TRAJAN_FOR_EACH_SHAPE_CLASS(TRAJAN_STENCIL)
#undef TRAJAN_STENCIL
  return nullptr;
}

int polynomial_degree(std::string_view shape_functions) {
  return shape_functions == "quadratic_bspline" ? 2 : shape_functions == "cubic_bspline" ? 3 : 1;
}

}  // namespace trajan
