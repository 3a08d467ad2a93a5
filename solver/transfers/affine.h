#pragma once

#include <limits>

#include "solver/transfers/gather.h"
#include "solver/transfers/locate.h"
#include "solver/transfers/scatter.h"

/// Velocities that vary linearly about their particle (Jiang, Schroeder and Teran 2017). A particle carries
/// B = sum w_I v_I (x_I - x_p)^T and gives the nodes the momentum m w_I (v + B D^-1 (x_I - x_p)), with
/// D = sum w_I (x_I - x_p)(x_I - x_p)^T where it is then: so angular momentum stays what it is while particles
/// move. Where shape functions are products D is diagonal.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

struct LeverSlopes {
  static const RealArray* along(const RealScratch& s, int axis) { return s.levers[axis].lever; }
};

/// Levers add up to zero and, times the distances of the nodes, to one. So do slopes, which they become where a
/// particle has all its weight on one node; by linear functions and Bernstein polynomials they are the same
/// everywhere. What rounding has left of the first sum goes to the nodes by their weights, lest a small D make
/// momentum of it.
template <int Nodes>
inline void find_levers_along(Block& block, int axis) {
  RealScratch& s = scratch_of(block);
  Levers<Real>& out = s.levers[axis];
  const Real* place = s.place[axis].data();
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    Real lever[Nodes], inertia = 0, sum = 0;
    for (int n = 0; n < Nodes; ++n) {
      const Real distance = Real(n) - place[i];
      lever[n] = s.weight[axis][n][i] * distance;
      inertia += lever[n] * distance;
    }
    // Some thousand roundings of the weights.
    const bool some = inertia > 4500 * std::numeric_limits<Real>::epsilon();
    const Real inverse = 1 / (some ? inertia : 1);
    for (int n = 0; n < Nodes; ++n) {
      lever[n] = some ? lever[n] * inverse : s.slope[axis][n][i];
      sum += lever[n];
    }
    for (int n = 0; n < Nodes; ++n) out.lever[n][i] = lever[n] - sum * s.weight[axis][n][i];
    out.inertia[i] = inertia;
  }
}

template <class Shape, int D>
inline void find_levers(Block& block) {
  for (int axis = 0; axis < D; ++axis) {
    if constexpr (Shape::nodes == 2) weigh_along<Shape>(block, axis);
    find_levers_along<Shape::nodes>(block, axis);
  }
}

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

template <class Stencil, Layout L>
inline void scatter_affine(Block& block) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  scatter<Stencil, L, D>(
      block, quantity(sum_momentum, 0, D), [&](int i) __attribute__((always_inline)) {
        const Real mass_per_cell = Real(block.mass(i) * block.sweep->inverse_cell);
        return [&, i, mass_per_cell ](Row, const Row* lever, Row* sums) __attribute__((always_inline)) {
#pragma GCC unroll 3
          for (int a = 0; a < D; ++a)
#pragma GCC unroll 3
            for (int b = 0; b < D; ++b)
              sums[a] = multiply_add(lever[b], spread<Row>(mass_per_cell * affine(block, a, b)[i]), sums[a]);
        };
      });
}

/// What B is of a vector of the nodes goes to the levers, per the cell size and D; the vector to `out`.
template <class Stencil, Layout L>
__attribute__((always_inline)) inline void gather_moments(Block& block, NodeVector vector, RealArray* out) {
  constexpr int D = L.dimensions;
  std::vector<Levers<Real>>& levers = scratch_of(block).levers;
  gather<Stencil, L>(
      block, vector, [&](int i, int a, const auto& sums) __attribute__((always_inline)) {
        store(out[a].values + i, sums[0]);
        for (int b = 0; b < D; ++b) store(levers[b].moment[a].values + i, sums[1 + b]);
      });
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
