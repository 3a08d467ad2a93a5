#pragma once

#include "solver/executors/instruction_set.h"
#include "solver/schemes/kernels.h"

/// What is done to the nodes of one tile. Sums are taken over the tiles around in a fixed order, so that
/// their bits do not depend on which thread does what.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Part of a tile's nodes that the window of a tile around covers, along one axis.
struct Overlap {
  int begin, end;  ///< of the tile's nodes
  int shift;       ///< window node = node + shift
  explicit Overlap(int neighbour)
      : begin(neighbour == 2 ? tile_side - 1 : 0),
        end(neighbour == 0 ? 2 : tile_side),
        shift(1 + tile_side * (1 - neighbour)) {}
};

/// Adds one quantity of all windows around to `out`, which has tile_nodes entries.
inline void collect(const NodeBlock& block, int quantity, double* __restrict out) {
  for (int i = 0; i < tile_nodes; ++i) out[i] = 0;
  for (int n = 0; n < 9; ++n) {
    if (!block.sums[n]) continue;
    const Overlap x(n % 3), y(n / 3);
    const double* in = block.sums[n] + quantity * window_nodes;
    for (int j = y.begin; j < y.end; ++j) {
      const double* row = in + (j + y.shift) * window_side + x.shift;
      double* target = out + j * tile_side;
      if (n % 3 == 1)
        for (int i = 0; i < tile_side; ++i) target[i] += row[i];
      else
        for (int i = x.begin; i < x.end; ++i) target[i] += row[i];
    }
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

inline void load_window(Window& window, const double* const* nodes, unsigned mask) {
  for (int q = 0; q < node_value_count; ++q) {
    if (!(mask >> q & 1u)) continue;
    WindowValue& v = window.values[q];
    for (int n = 0; n < 9; ++n) {
      // The nodes that this tile's window takes of the tile around mirror those that it gives.
      const int x_begin = n % 3 == 0 ? tile_side - 1 : 0, x_end = n % 3 == 2 ? 2 : tile_side;
      const int y_begin = n / 3 == 0 ? tile_side - 1 : 0, y_end = n / 3 == 2 ? 2 : tile_side;
      const int x_shift = 1 + tile_side * (n % 3 - 1), y_shift = 1 + tile_side * (n / 3 - 1);
      for (int j = y_begin; j < y_end; ++j)
        for (int i = x_begin; i < x_end; ++i)
          v.base[(j + y_shift) * window_side + i + x_shift] =
              nodes[n] ? nodes[n][q * tile_nodes + j * tile_side + i] : 0.0;
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
