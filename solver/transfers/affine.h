#pragma once

#include "solver/transfers/gather.h"
#include "solver/transfers/levers.h"
#include "solver/transfers/scatter.h"

/// Velocities that vary linearly about their particle (Jiang, Schroeder and Teran 2017). A particle carries
/// B = sum w_I v_I (x_I - x_p)^T and gives the nodes the momentum m w_I (v + B D^-1 (x_I - x_p)), with
/// D = sum w_I (x_I - x_p)(x_I - x_p)^T where it is then: so angular momentum stays what it is while particles
/// move. Where shape functions are products D is diagonal.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// A component of the matrix that particles carry.
__attribute__((always_inline)) inline Real* affine(const Block& block, int a, int b) {
  return component_of(block, Attribute::affine_xx, 3 * a + b);
}

/// The gradient of velocities that vary linearly becomes B = gradient D.
template <int D>
inline void begin_affine(Block& block) {
  const Real square = Real(block.sweep->cell * block.sweep->cell);
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b)
      for (int i = 0; i < block.count; ++i)
        affine(block, a, b)[i] *= square * scratch_of(block).levers[b].inertia[i];
}

/// A row's momentum of a particle whose velocity varies linearly. Slopes are levers.
template <int D>
struct AffineVelocity {
  template <class Row>
  __attribute__((always_inline)) static Row add_momentum(const Block& block, int axis, int i, Row m,
                                                         const Row* levers, Row sum) {
    sum = UniformVelocity::add_momentum(block, axis, i, m, levers, sum);
#pragma GCC unroll 3
    for (int b = 0; b < D; ++b)
      sum = multiply_add(levers[b], spread<Row>(scratch_of(block).levers[b].moment[axis].values[i]), sum);
    return sum;
  }
};

/// Mass times B, over the cell size, to the levers' moments, for AffineVelocity.
template <int D>
inline void weigh_affine(Block& block) {
  const double inverse_cell = block.sweep->inverse_cell;
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) {
      const Real* of_particles = affine(block, a, b);
      Real* moment = scratch_of(block).levers[b].moment[a].values;
#pragma GCC ivdep
      for (int i = 0; i < block.count; ++i) moment[i] = Real(block.mass(i) * inverse_cell) * of_particles[i];
    }
}

/// Momentum of velocities that vary goes with that of the particles' own, where weights and sums are at hand: in a
/// plane by quadratic B-splines, by profiles, 4 ns less per particle and step than by itself.
template <class Stencil, Layout L>
inline void scatter_affine_state(Block& block) {
  weigh_affine<L.dimensions>(block);
  scatter_state<Stencil, L, AffineVelocity<L.dimensions>>(block);
}
template <class Stencil, Layout L>
inline void scatter_affine_momentum(Block& block) {
  weigh_affine<L.dimensions>(block);
  scatter_momentum<Stencil, L, AffineVelocity<L.dimensions>>(block);
}

/// What B is of a vector of the nodes goes to the levers, per the cell size and D; the vector to `out`.
template <class Stencil, Layout L>
__attribute__((always_inline)) inline void gather_moments(Block& block, NodeVector vector, RealArray* out) {
  std::vector<Levers<Real>>& levers = scratch_of(block).levers;
  const auto keep = [&](int i, int a, const auto& sums) __attribute__((always_inline)) {
    store(out[a].values + i, sums[0]);
    for (int b = 0; b < L.dimensions; ++b) store(levers[b].moment[a].values + i, sums[1 + b]);
  };
  gather<Stencil, L>(block, Gathered{vector, keep});
}

/// The grid's velocity, and B of it.
template <class Stencil, Layout L>
inline void gather_affine(Block& block) {
  constexpr int D = L.dimensions;
  const RealScratch& s = scratch_of(block);
  const Real cell = Real(block.sweep->cell);
  gather_moments<Stencil, L>(block, node_velocity, scratch_of(block).velocity);
  for (int ab = 0; ab < D * D; ++ab) {
    Real* b = affine(block, ab / D, ab % D);
    const Real *moment = s.levers[ab % D].moment[ab / D].values, *inertia = s.levers[ab % D].inertia.values;
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) b[i] = cell * inertia[i] * moment[i];
  }
}

/// The grid's acceleration, and B += dt sum w_I a_I (x_I - x_p)^T.
template <class Stencil, Layout L>
inline void kick_affine(Block& block) {
  constexpr int D = L.dimensions;
  const RealScratch& s = scratch_of(block);
  const Real cell = Real(block.sweep->cell), dt = Real(block.sweep->kick);
  gather_moments<Stencil, L>(block, node_acceleration, scratch_of(block).acceleration);
  for (int ab = 0; ab < D * D; ++ab) {
    Real* b = affine(block, ab / D, ab % D);
    const Real *moment = s.levers[ab % D].moment[ab / D].values, *inertia = s.levers[ab % D].inertia.values;
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) b[i] += dt * (cell * inertia[i] * moment[i]);
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
