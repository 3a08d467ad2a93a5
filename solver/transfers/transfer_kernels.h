#pragma once

#include <type_traits>

#include "solver/transfers/affine.h"
#include "solver/transfers/gather.h"
#include "solver/transfers/locate.h"
#include "solver/transfers/node_updates.h"
#include "solver/transfers/projection.h"
#include "solver/transfers/scatter.h"

/// The table of one kind of shape functions.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Levers are products like the shape functions, so that they need those to be.
template <class Shape, Layout L, class Stencil>
constexpr AffineKernels affine_kernels() {
  if constexpr (std::is_same_v<Stencil, ProductStencil<Shape::nodes, L, ShapeSlopes>>) {
    using Levers = ProductStencil<Shape::nodes, L, LeverSlopes>;
    using Both = ProductStencil<Shape::nodes, L, ShapeSlopes, LeverSlopes>;
    return {&find_levers<Shape, L.dimensions>,   &begin_affine<L.dimensions>, &scatter_affine_state<Both, L>,
            &scatter_affine_momentum<Levers, L>, &gather_affine<Levers, L>,   &kick_affine<Levers, L>};
  } else {
    return {};
  }
}

template <class Shape, Layout L, class Stencil = ProductStencil<Shape::nodes, L, ShapeSlopes>,
          Stage Locate = &locate<Shape, L>>
inline constexpr TransferKernels transfer_kernels{L,
                                                  1,
                                                  0,
                                                  Shape::needs_deformation,
                                                  Shape::first_node(3.25) != Shape::first_node(3.75),
                                                  Locate,
                                                  &scatter_state<Stencil, L>,
                                                  &scatter_hoop<Stencil, L>,
                                                  &scatter_loads<Stencil, L>,
                                                  &scatter_mass<Stencil, L>,
                                                  &scatter_momentum<Stencil, L>,
                                                  &gather_acceleration<Stencil, L>,
                                                  &gather_velocity<Stencil, L>,
                                                  &gather_gradient<Stencil, L>,
                                                  &gather_motion<Stencil, L>,
                                                  &gather_hoop<Stencil, L>,
                                                  &update_velocities<L>,
                                                  &map_velocities<L>,
                                                  &load_window<L>,
                                                  affine_kernels<Shape, L, Stencil>(),
                                                  &gather_projected<Stencil, L>,
                                                  &remap<Stencil, L>,
                                                  &reduce_remainder<L>};

template <class Shape>
struct TransferChoice {
  static const TransferKernels* of(Dimension dimension) {
    switch (grid_axes(dimension)) {
      case 1:
        return &transfer_kernels<Shape, Layout{1, Shape::wide}>;
      case 2:
        return &transfer_kernels<Shape, Layout{2, Shape::wide}>;
      default:
        return &transfer_kernels<Shape, Layout{3, Shape::wide}>;
    }
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
