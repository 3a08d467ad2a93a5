#pragma once

#include "solver/transfers/gather.h"
#include "solver/transfers/scatter.h"

/// Velocities that vary linearly about their particle (Jiang, Schroeder and Teran 2017). A particle carries
/// B = sum w_I v_I (x_I - x_p)^T and gives the nodes the momentum m w_I (v + B D^-1 (x_I - x_p)), with
/// D = sum w_I (x_I - x_p)(x_I - x_p)^T where it is then: so angular momentum stays what it is while particles
/// move. Where shape functions are products D is diagonal.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

struct LeverSlopes {
  static const BlockArray* along(const Scratch& s, int axis) { return s.levers[axis].lever; }
};

/// Levers add up to zero and, times the distances of the nodes, to one. So do slopes, which they become where a
/// particle has all its weight on one node; by linear functions and Bernstein polynomials they are the same
/// everywhere. What rounding has left of the first sum goes to the nodes by their weights, lest a small D make
/// momentum of it.
template <int Nodes>
inline void find_levers_along(Block& block, int axis) {
  Scratch& s = *block.scratch;
  Levers& out = s.levers[axis];
  const double* place = s.place[axis].data();
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    double lever[Nodes], inertia = 0, sum = 0;
    for (int n = 0; n < Nodes; ++n) {
      const double distance = n - place[i];
      lever[n] = s.weight[axis][n][i] * distance;
      inertia += lever[n] * distance;
    }
    // A thousand roundings of the weights.
    const bool some = inertia > 1e-12;
    const double inverse = 1 / (some ? inertia : 1);
    for (int n = 0; n < Nodes; ++n) {
      lever[n] = some ? lever[n] * inverse : s.slope[axis][n][i];
      sum += lever[n];
    }
    for (int n = 0; n < Nodes; ++n) out.lever[n][i] = lever[n] - sum * s.weight[axis][n][i];
    out.inertia[i] = inertia;
  }
}

template <int Nodes, int D>
inline void find_levers(Block& block) {
  for (int axis = 0; axis < D; ++axis) find_levers_along<Nodes>(block, axis);
}

/// A component of the matrix that particles carry.
__attribute__((always_inline)) inline double* affine(const Block& block, int a, int b) {
  return block[static_cast<Attribute>(static_cast<int>(Attribute::affine_xx) + 3 * a + b)];
}

/// The gradient of velocities that vary linearly becomes B = gradient D.
template <int D>
inline void begin_affine(Block& block) {
  const double square = block.sweep->cell * block.sweep->cell;
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b)
      for (int i = 0; i < block.count; ++i) affine(block, a, b)[i] *= square * block.scratch->levers[b].inertia[i];
}

template <class Stencil, Layout L>
inline void scatter_affine(Block& block) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  for (int i = 0; i < block.count; ++i) {
    const double mass_per_cell = block.mass(i) * block.sweep->inverse_cell;
    double moment[D * D];
    for (int ab = 0; ab < D * D; ++ab) moment[ab] = mass_per_cell * affine(block, ab / D, ab % D)[i];
    double* momenta = sums_of<L>(block, sum_momentum, i);
    Stencil(*block.scratch, i).for_each_row([&](int at, Row, const Row* lever) __attribute__((always_inline)) {
      for (int a = 0; a < D; ++a) {
        Row p = lever[0] * moment[a * D];
        for (int b = 1; b < D; ++b) p += lever[b] * moment[a * D + b];
        add(momenta + a * L.window_nodes + at, p);
      }
    });
  }
}

/// Calls put(component of B, value) with what B is of a vector of the nodes.
template <class Stencil, Layout L, class Put>
__attribute__((always_inline)) inline void gather_moments(Block& block, NodeVector vector, Put&& put) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  const Scratch& s = *block.scratch;
  for (int i = 0; i < block.count; ++i) {
    const double* nodes = values_of<L>(s, vector, i);
    Row moment[D * D] = {};
    Stencil(s, i).for_each_row([&](int at, Row, const Row* lever) __attribute__((always_inline)) {
      for (int a = 0; a < D; ++a) {
        const Row value = load<Row>(nodes + a * L.window_nodes + at);
        for (int b = 0; b < D; ++b) moment[a * D + b] += lever[b] * value;
      }
    });
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b)
        put(affine(block, a, b)[i], block.sweep->cell * s.levers[b].inertia.values[i] * sum(moment[a * D + b]));
  }
}

template <class Stencil, Layout L>
inline void gather_affine(Block& block) {
  gather_moments<Stencil, L>(
      block, node_velocity, [](double& b, double moment) __attribute__((always_inline)) { b = moment; });
}

/// B += dt sum w_I a_I (x_I - x_p)^T.
template <class Stencil, Layout L>
inline void kick_affine(Block& block) {
  const double dt = block.sweep->kick;
  gather_moments<Stencil, L>(
      block,
      node_acceleration, [dt](double& b, double moment) __attribute__((always_inline)) { b += dt * moment; });
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
