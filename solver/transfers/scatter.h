#pragma once

#include "solver/transfers/stencil.h"

/// Particles to grid, with any shape functions.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The sums of one vector, its components one window apart.
template <Layout L>
__attribute__((always_inline)) inline double* sums_of(const Block& block, SumVector vector, int i) {
  return block.sums + quantity(vector, 0, L.dimensions) * L.window_nodes + block.scratch->cell[i];
}

/// Mass, momentum and internal force.
template <class Stencil, Layout L>
inline void scatter_state(Block& block) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  Scratch& s = *block.scratch;
  for (int i = 0; i < block.count; ++i) {
    const double mass = block.mass(i);
    double momentum[D], force[D * D];
    for (int a = 0; a < D; ++a) momentum[a] = mass * block.component(Attribute::velocity_x, a)[i];
    for (int a = 0; a < D * D; ++a) force[a] = -s.force[a][i];
    double* masses = block.sums + s.cell[i];
    double* momenta = sums_of<L>(block, sum_momentum, i);
    double* forces = sums_of<L>(block, sum_force, i);
    Stencil(s, i).for_each_row([&](int at, Row w, const Row* slope) __attribute__((always_inline)) {
      add(masses + at, w * mass);
      for (int a = 0; a < D; ++a) {
        add(momenta + a * L.window_nodes + at, w * momentum[a]);
        Row f = slope[0] * force[a * D];
        for (int b = 1; b < D; ++b) f += slope[b] * force[a * D + b];
        add(forces + a * L.window_nodes + at, f);
      }
    });
  }
}

template <class Stencil, Layout L>
inline void scatter_mass(Block& block) {
  using Row = typename Stencil::Row;
  for (int i = 0; i < block.count; ++i) {
    const double mass = block.mass(i);
    double* sums = block.sums + block.scratch->cell[i];
    Stencil(*block.scratch, i).for_each_row([&](int at, Row w, const Row*) __attribute__((always_inline)) {
      add(sums + at, w * mass);
    });
  }
}

/// A vector that particles of mass m have, times m.
template <class Stencil, Layout L, class Value>
__attribute__((always_inline)) inline void scatter_vector(Block& block, SumVector vector, Value&& value) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  for (int i = 0; i < block.count; ++i) {
    const double mass = block.mass(i);
    double weighted[D];
    for (int a = 0; a < D; ++a) weighted[a] = mass * value(a, i);
    double* sums = sums_of<L>(block, vector, i);
    Stencil(*block.scratch, i).for_each_row([&](int at, Row w, const Row*) __attribute__((always_inline)) {
      for (int a = 0; a < D; ++a) add(sums + a * L.window_nodes + at, w * weighted[a]);
    });
  }
}

/// Momentum alone, for the second mapping of MUSL.
template <class Stencil, Layout L>
inline void scatter_momentum(Block& block) {
  scatter_vector<Stencil, L>(
      block, sum_momentum, [&](int a, int i) __attribute__((always_inline)) {
        return block.component(Attribute::velocity_x, a)[i];
      });
}

/// Loads on the particles' mass.
template <class Stencil, Layout L>
inline void scatter_loads(Block& block) {
  scatter_vector<Stencil, L>(
      block, sum_load, [&](int a, int i) __attribute__((always_inline)) { return block.scratch->load[a][i]; });
}

/// Axisymmetric: the hoop stress pulls towards the axis, with volume times stress over radius per radian
/// (Sulsky and Schreyer 1996).
template <class Stencil, Layout L>
inline void scatter_hoop(Block& block) {
  using Row = typename Stencil::Row;
  Scratch& s = *block.scratch;
  const double* radius = block[Attribute::position_x];
  for (int i = 0; i < block.count; ++i) {
    const double force = -s.virial_rest[i] / radius[i];
    double* sums = sums_of<L>(block, sum_force, i);
    Stencil(s, i).for_each_row([&](int at, Row w, const Row*)
                                   __attribute__((always_inline)) { add(sums + at, w * force); });
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
