#pragma once

#include <type_traits>

#include "solver/transfers/affine.h"
#include "solver/transfers/gather.h"
#include "solver/transfers/hoop.h"
#include "solver/transfers/locate.h"
#include "solver/transfers/node_updates.h"
#include "solver/transfers/projection.h"
#include "solver/transfers/regular_affine.h"
#include "solver/transfers/scatter.h"

/// The table of one kind of shape functions.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <class Shape, Layout L>
inline constexpr AffineKernels levered_kernels = [] {
  constexpr int D = L.dimensions, nodes = Shape::nodes;
  using Levers = ProductStencil<nodes, L, LeverSlopes>;
  using Both = ProductStencil<nodes, L, ShapeSlopes, LeverSlopes>;
  using Velocity = LeveredVelocity<D>;
  return AffineKernels{&find_levers<Shape, D>,
                       &locate<Shape, L>,
                       &begin_affine<Shape, D>,
                       &scatter_affine_state<Both, L, Velocity>,
                       &scatter_affine_momentum<Levers, L, Velocity>,
                       &gather_affine<nodes, L, LeverSlopes>,
                       &kick_affine<nodes, L, LeverSlopes>};
}();

/// Levers are products like the shape functions, so that they need those to be.
template <class Shape, Layout L, class Stencil>
constexpr AffineKernels affine_kernels() {
  if constexpr (!std::is_same_v<Stencil, ProductStencil<Shape::nodes, L, ShapeSlopes>>)
    return {};
  else if constexpr (Regular<Shape>)
    return regular_affine_kernels<Shape, L, Stencil, levered_kernels<Shape, L>>();
  else
    return levered_kernels<Shape, L>;
}

template <class Shape, Layout L, class Stencil = ProductStencil<Shape::nodes, L, ShapeSlopes>,
          Stage Locate = &locate<Shape, L>, Stage LocateValues = &locate<Shape, L, Shape::nodes == 2>>
inline constexpr TransferKernels transfer_kernels{L,
                                                  0,
                                                  Shape::needs_deformation,
                                                  has_strips<Stencil>,
                                                  Locate,
                                                  LocateValues,
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

/// Returns of.operator()<Layout>().
template <Reach reach, Margin margin, class Of>
auto with_layout(Dimension dimension, Of of) {
  switch (grid_axes(dimension)) {
    case 1:
      return of.template operator()<Layout{1, reach, margin}>();
    case 2:
      return of.template operator()<Layout{2, reach, margin}>();
    default:
      return of.template operator()<Layout{3, reach, margin}>();
  }
}

/// Particles that deform are of no scheme in which they stay where they are.
template <class Shape>
concept NeedsMargin = Shape::needs_deformation || requires {
  requires Shape::needs_margin;
};

/// With a margin if the shape functions need one.
template <class Shape>
struct TransferChoice {
  static const TransferKernels* of(Dimension dimension, Margin margin) {
    const auto kernels = []<Layout L>() { return &transfer_kernels<Shape, L>; };
    if constexpr (!NeedsMargin<Shape>)
      if (margin == Margin::none) return with_layout<Shape::reach, Margin::none>(dimension, kernels);
    return with_layout<Shape::reach, Margin::one_cell>(dimension, kernels);
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
