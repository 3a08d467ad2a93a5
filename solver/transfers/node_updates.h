#pragma once

#include <algorithm>

#include "solver/executors/instruction_set.h"
#include "solver/schemes/kernels.h"
#include "solver/transfers/windows.h"

/// What is done to the nodes of one tile.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Accelerations and velocities from mass, momentum and forces; damping is -damping times the momentum.
template <Layout L>
inline void update_velocities(NodeBlock& block) {
  constexpr int D = L.dimensions;
  NodeSums& sums = *block.collected;
  for (int q = 0; q < block.sum_quantities; ++q) collect<L>(block.sums, q, sums.values[q]);
  double* mass = block.nodes + tile_array(quantity_mass);
  alignas(64) double inverse[tile_nodes];
  for (int i = 0; i < tile_nodes; ++i) {
    mass[i] = sums.values[quantity_mass][i];
    inverse[i] = mass[i] > block.least_mass ? 1 / mass[i] : 0;
  }
  for (int axis = 0; axis < D; ++axis) {
    const double* p = sums.values[quantity(sum_momentum, axis, D)];
    const double* f = sums.values[quantity(sum_force, axis, D)];
    const double* load = sums.values[quantity(sum_load, axis, D)];
    double* a = block.nodes + tile_array(quantity(node_acceleration, axis, D));
    double* u = block.nodes + tile_array(quantity(node_velocity, axis, D));
    const double kick = block.kick, damping = block.damping;
    for (int i = 0; i < tile_nodes; ++i) {
      a[i] = (f[i] + load[i] - damping * p[i]) * inverse[i];
      u[i] = p[i] * inverse[i] + kick * a[i];
    }
  }
}

/// Work of loads and dissipation by damping in a leapfrog kick: force times the mean of the velocities
/// before and after it. To be called once velocities are final.
template <int D>
inline void account(NodeBlock& block) {
  const NodeSums& sums = *block.collected;
  double work = 0, dissipated = 0;
  for (int axis = 0; axis < D; ++axis) {
    const double* p = sums.values[quantity(sum_momentum, axis, D)];
    const double* load = sums.values[quantity(sum_load, axis, D)];
    const double* a = block.nodes + tile_array(quantity(node_acceleration, axis, D));
    const double* u = block.nodes + tile_array(quantity(node_velocity, axis, D));
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
template <Layout L>
inline void map_velocities(NodeBlock& block) {
  constexpr int D = L.dimensions;
  alignas(64) double p[tile_nodes];
  double* mass = block.nodes + tile_array(quantity_mass);
  if (block.collect_mass) collect<L>(block.sums, quantity_mass, mass);
  for (int axis = 0; axis < D; ++axis) {
    collect<L>(block.sums, quantity(sum_momentum, axis, D), p);
    double* w = block.nodes + tile_array(quantity(node_mapped_velocity, axis, D));
    for (int i = 0; i < tile_nodes; ++i) w[i] = mass[i] > block.least_mass ? p[i] / mass[i] : 0;
  }
}

/// Velocities for gradients where momentum is not mapped a second time: those of the nodes, but on a node that
/// particles hardly reach those before the kick: forces are as large there as on others. To be called once
/// velocities are final.
template <int D>
inline void calm_light_nodes(NodeBlock& block) {
  const double* mass = block.nodes + tile_array(quantity_mass);
  for (int axis = 0; axis < D; ++axis) {
    const double* a = block.nodes + tile_array(quantity(node_acceleration, axis, D));
    const double* u = block.nodes + tile_array(quantity(node_velocity, axis, D));
    double* w = block.nodes + tile_array(quantity(node_mapped_velocity, axis, D));
    for (int i = 0; i < tile_nodes; ++i) {
      const bool light = mass[i] > block.least_mass && mass[i] < block.light_mass;
      w[i] = light ? u[i] - block.kick * a[i] : u[i];
    }
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
