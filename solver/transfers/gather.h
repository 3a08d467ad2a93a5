#pragma once

#include "solver/transfers/stencil.h"

/// Grid to particles, with any shape functions.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <Layout L>
__attribute__((always_inline)) inline const double* values_of(const Scratch& s, NodeVector vector, int i) {
  return s.window + quantity(vector, 0, L.dimensions) * L.window_nodes + s.cell[i];
}

/// Of one vector at the particles.
template <class Stencil, Layout L>
__attribute__((always_inline)) inline void gather_vector(Block& block, NodeVector vector, BlockArray* out) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  Scratch& s = *block.scratch;
  for (int i = 0; i < block.count; ++i) {
    const double* nodes = values_of<L>(s, vector, i);
    Row value[D] = {};
    Stencil(s, i).for_each_row([&](int at, Row w, const Row*) __attribute__((always_inline)) {
      for (int a = 0; a < D; ++a) value[a] += w * load<Row>(nodes + a * L.window_nodes + at);
    });
    for (int a = 0; a < D; ++a) out[a][i] = sum(value[a]);
  }
}

template <class Stencil, Layout L>
inline void gather_acceleration(Block& block) {
  gather_vector<Stencil, L>(block, node_acceleration, block.scratch->acceleration);
}

template <class Stencil, Layout L>
inline void gather_velocity(Block& block) {
  gather_vector<Stencil, L>(block, node_velocity, block.scratch->velocity);
}

/// Gradient of the velocity that is for gradients.
template <class Stencil, Layout L>
inline void gather_gradient(Block& block) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  Scratch& s = *block.scratch;
  const double per_cell = block.sweep->inverse_cell;
  for (int i = 0; i < block.count; ++i) {
    const double* nodes = values_of<L>(s, node_mapped_velocity, i);
    Row gradient[D * D] = {};
    Stencil(s, i).for_each_row([&](int at, Row, const Row* slope) __attribute__((always_inline)) {
      for (int a = 0; a < D; ++a) {
        const Row value = load<Row>(nodes + a * L.window_nodes + at);
        for (int b = 0; b < D; ++b) gradient[a * D + b] += slope[b] * value;
      }
    });
    for (int ab = 0; ab < D * D; ++ab) s.gradient[ab][i] = per_cell * sum(gradient[ab]);
  }
}

/// Velocity of the grid, and gradient of the one that is for gradients.
template <class Stencil, Layout L>
inline void gather_motion(Block& block) {
  gather_velocity<Stencil, L>(block);
  gather_gradient<Stencil, L>(block);
}

/// Axisymmetric: hoop strain rate of the velocity that is for gradients.
template <class Stencil, Layout L>
inline void gather_hoop(Block& block) {
  using Row = typename Stencil::Row;
  Scratch& s = *block.scratch;
  const double* radius = block[Attribute::position_x];
  for (int i = 0; i < block.count; ++i) {
    const double* nodes = values_of<L>(s, node_mapped_velocity, i);
    Row value{};
    Stencil(s, i).for_each_row([&](int at, Row w, const Row*)
                                   __attribute__((always_inline)) { value += w * load<Row>(nodes + at); });
    s.gradient_rest[i] = sum(value) / radius[i];
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
