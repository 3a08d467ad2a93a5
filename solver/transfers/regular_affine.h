#pragma once

#include "solver/transfers/affine.h"

/// Affine velocities by B-splines away from faces of the domain, where D is `Shape::inertia` wherever a particle
/// is: no levers are to be found, and what nodes get is a velocity that is linear in space. In a plane by
/// quadratic B-splines 10 ns less per particle and step.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <class Shape>
concept Regular = requires {
  Shape::inertia;
};

template <class Shape, int D>
inline bool is_regular(const Block& block) {
  for (int axis = 0; axis < D; ++axis)
    if (reaches_a_face<Shape::reach>(block, axis)) return false;
  return true;
}

/// Momentum from the velocity at a stencil's first node and the velocity's gradient, which is `per_node` of what
/// the particle carries for every node.
template <class Shape, int D>
struct LinearVelocity {
  static void prepare(Block& block) {
    const RealScratch& s = scratch_of(block);
    const Real factor = per_node(block);
    for (int a = 0; a < D; ++a) {
      const Real* at_particle = component_of(block, Attribute::velocity_x, a);
      const Real *moment[D], *place[D];
      for (int b = 0; b < D; ++b) {
        moment[b] = affine(block, a, b);
        place[b] = s.place[b].values;
      }
      Real* at_first = scratch_of(block).velocity[a].values;
#pragma GCC ivdep
      for (int i = 0; i < block.count; ++i) {
        Real change = 0;
#pragma GCC unroll 3
        for (int b = 0; b < D; ++b) change += moment[b][i] * place[b][i];
        at_first[i] = at_particle[i] - factor * change;
      }
    }
  }
  static Real per_node(const Block& block) { return Real(block.sweep->inverse_cell) / Shape::inertia; }

  template <class Strips>
  __attribute__((always_inline)) static auto given(const Strips& strips, double* to, const Block& block,
                                                   int axis) {
    return strips.linear_momentum(to, scratch_of(block).velocity[axis].values, affine(block, axis, 0),
                                  affine(block, axis, 1), per_node(block));
  }
  /// A row's momentum.
  template <class Row, class Particles>
  class Of {
   public:
    __attribute__((always_inline)) Of(const Block& block, Particles particles) : per_node_(per_node(block)) {
      const Row along_x = per_node_ * particles.template node_numbers<Row>();
#pragma GCC unroll 3
      for (int a = 0; a < D; ++a) {
        first_row_[a] = multiply_add(along_x, particles.template each<Row>(affine(block, a, 0)),
                                     particles.template each<Row>(scratch_of(block).velocity[a].values));
#pragma GCC unroll 3
        for (int b = 1; b < D; ++b) moment_[b - 1][a] = particles.template each<Row>(affine(block, a, b));
      }
    }
    __attribute__((always_inline)) Row add_momentum(int axis, int row, Row m, const Row*, Row sum) const {
      const int along[] = {row % Shape::nodes, row / Shape::nodes};
      Row velocity = first_row_[axis];
#pragma GCC unroll 2
      for (int b = D - 2; b >= 0; --b)
        if (along[b] > 0)
          velocity = multiply_add(spread<Row>(Real(along[b]) * per_node_), moment_[b][axis], velocity);
      return multiply_add(m, velocity, sum);
    }

   private:
    Real per_node_;
    Row first_row_[D], moment_[2][D];
  };
};

/// One of two stages, by whether a block is regular.
template <class Shape, int D, Stage OfRegular, Stage OfOthers>
inline void by_place(Block& block) {
  is_regular<Shape, D>(block) ? OfRegular(block) : OfOthers(block);
}
inline void find_no_levers(Block&) {}

/// `general`: for blocks anywhere.
template <class Shape, Layout L, class Stencil, const AffineKernels& general>
constexpr AffineKernels regular_affine_kernels() {
  constexpr int D = L.dimensions, nodes = Shape::nodes;
  using Velocity = LinearVelocity<Shape, D>;
  using Slopes = WeighedDistances;
  return {&by_place<Shape, D, &find_no_levers, general.find_levers>,
          &by_place<Shape, D, &locate<Shape, L, false>, general.locate_values>,
          general.begin,
          &by_place<Shape, D, &scatter_affine_state<Stencil, L, Velocity>, general.scatter_state>,
          &by_place<Shape, D, &scatter_affine_momentum<Stencil, L, Velocity>, general.scatter_momentum>,
          &by_place<Shape, D, &gather_affine<nodes, L, Slopes>, general.gather>,
          &by_place<Shape, D, &kick_affine<nodes, L, Slopes>, general.kick>,
          has_strips<Stencil>};
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
