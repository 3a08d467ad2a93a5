#pragma once

#include "solver/executors/instruction_set.h"
#include "solver/schemes/kernels.h"
#include "solver/transfers/cells.h"

/// What is done to the nodes of one tile. Sums are taken over the tiles around in a fixed order, so that
/// their bits do not depend on which thread does what.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

typedef double Eight __attribute__((vector_size(64)));

/// Adds one quantity of all windows around to `out`, which has tile_nodes entries. Of the window of the
/// tile to the left, columns 9 and 10 are this tile's columns 0 and 1, of the one to the right column 0 is
/// this tile's column 7; rows likewise.
inline void collect(const NodeBlock& block, int quantity, double* __restrict out) {
  const auto add_row = [&](int n, int row, Eight sum) __attribute__((always_inline)) {
    const int at = quantity * window_nodes + row * window_side;
    const double* left = block.sums[n] + at;
    const double* right = block.sums[n + 2] + at;
    sum += Eight{left[tile_side + 1], left[tile_side + 2], 0, 0, 0, 0, 0, 0};
    sum += load<Eight>(block.sums[n + 1] + at + 1);
    sum += Eight{0, 0, 0, 0, 0, 0, 0, right[0]};
    return sum;
  };
  for (int j = 0; j < tile_side; ++j) {
    Eight sum{};
    if (j < 2) sum = add_row(0, j + tile_side + 1, sum);
    sum = add_row(3, j + 1, sum);
    if (j == tile_side - 1) sum = add_row(6, 0, sum);
    store(out + j * tile_side, sum);
  }
}

/// Accelerations and velocities from mass, momentum and forces; damping is -damping times the momentum.
inline void update_velocities(NodeBlock& block) {
  NodeSums& sums = *block.collected;
  for (int q = 0; q < block.sum_arrays; ++q) collect(block, q, sums.values[q]);
  double* mass = block.nodes + node_mass * tile_nodes;
  for (int i = 0; i < tile_nodes; ++i) mass[i] = sums.values[sum_mass][i];
  for (int axis = 0; axis < 2; ++axis) {
    const double* p = sums.values[sum_momentum_x + axis];
    const double* f = sums.values[sum_force_x + axis];
    const double* load = sums.values[sum_load_x + axis];
    double* a = block.nodes + (node_acceleration_x + axis) * tile_nodes;
    double* u = block.nodes + (node_velocity_x + axis) * tile_nodes;
    const double kick = block.kick, damping = block.damping, least = block.least_mass;
    for (int i = 0; i < tile_nodes; ++i) {
      const double inverse = mass[i] > least ? 1 / mass[i] : 0;
      a[i] = (f[i] + load[i] - damping * p[i]) * inverse;
      u[i] = p[i] * inverse + kick * a[i];
    }
  }
}

/// Work of loads and dissipation by damping in a leapfrog kick: force times the mean of the velocities
/// before and after it. To be called once velocities are final.
inline void account(NodeBlock& block) {
  const NodeSums& sums = *block.collected;
  double work = 0, dissipated = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const double* p = sums.values[sum_momentum_x + axis];
    const double* load = sums.values[sum_load_x + axis];
    const double* a = block.nodes + (node_acceleration_x + axis) * tile_nodes;
    const double* u = block.nodes + (node_velocity_x + axis) * tile_nodes;
    for (int i = 0; i < tile_nodes; ++i) {
      const double mean = u[i] - 0.5 * block.kick * a[i];
      work += load[i] * mean;
      dissipated += p[i] * mean;
    }
  }
  block.work = block.kick * work;
  block.dissipated = block.kick * block.damping * dissipated;
}

/// Velocities from the momentum that was mapped a second time.
inline void map_velocities(NodeBlock& block) {
  alignas(64) double p[tile_nodes];
  const double* mass = block.nodes + node_mass * tile_nodes;
  for (int axis = 0; axis < 2; ++axis) {
    collect(block, sum_momentum_x + axis, p);
    double* w = block.nodes + (node_mapped_velocity_x + axis) * tile_nodes;
    for (int i = 0; i < tile_nodes; ++i) w[i] = mass[i] > block.least_mass ? p[i] / mass[i] : 0;
  }
}

/// Velocities for gradients where momentum is not mapped a second time: those of the nodes, but on a node that
/// particles hardly reach without what internal forces have done to it. To be called once velocities are final.
inline void calm_light_nodes(NodeBlock& block) {
  const double* mass = block.nodes + node_mass * tile_nodes;
  for (int axis = 0; axis < 2; ++axis) {
    const double* f = block.collected->values[sum_force_x + axis];
    const double* u = block.nodes + (node_velocity_x + axis) * tile_nodes;
    double* w = block.nodes + (node_mapped_velocity_x + axis) * tile_nodes;
    for (int i = 0; i < tile_nodes; ++i) {
      const bool light = mass[i] > block.least_mass && mass[i] < block.light_mass;
      w[i] = light ? u[i] - block.kick * f[i] / mass[i] : u[i];
    }
  }
}

inline void load_window(Window& window, const std::array<const double*, 9>& nodes, unsigned mask) {
  for (int q = 0; q < node_value_count; ++q) {
    if (!(mask >> q & 1u)) continue;
    WindowValue& v = window.values[q];
    for (int row = 0; row < window_side; ++row) {
      const int j = row - 1, n = j < 0 ? 0 : j < tile_side ? 3 : 6;
      const int at = q * tile_nodes + (j & (tile_side - 1)) * tile_side;
      double* out = v.base + row * window_side;
      out[0] = nodes[n][at + tile_side - 1];
      store(out + 1, load<Eight>(nodes[n + 1] + at));
      store(out + 1 + tile_side, load<Pair>(nodes[n + 2] + at));
    }
    // Where the last row and column have no right or upper neighbour, no cell begins.
    constexpr int cells = window_side * (window_side - 1) - 1;
    for (int k = 0; k < cells; ++k) {
      const double right = v.base[k + 1] - v.base[k];
      v.dx[k] = right;
      v.dy[k] = v.base[k + window_side] - v.base[k];
      v.dxy[k] = (v.base[k + window_side + 1] - v.base[k + window_side]) - right;
    }
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
