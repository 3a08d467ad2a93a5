#include "solver/simulation/force_balance.h"

namespace trajan {

ForceBalance force_balance(const NodeBlock& block, int axes) {
  ForceBalance balance;
  const NodeSums& sums = *block.collected;
  const double* mass = block.nodes + quantity_mass * tile_nodes;
  for (int axis = 0; axis < axes; ++axis) {
    const double* force = sums.values[quantity(sum_force, axis, axes)];
    const double* load = sums.values[quantity(sum_load, axis, axes)];
    const double* momentum = sums.values[quantity(sum_momentum, axis, axes)];
    const double* acceleration = block.nodes + quantity(node_acceleration, axis, axes) * tile_nodes;
    const double* velocity = block.nodes + quantity(node_velocity, axis, axes) * tile_nodes;
    for (int i = 0; i < tile_nodes; ++i) {
      if (!(mass[i] > block.least_mass)) continue;
      const double net = mass[i] * acceleration[i] + block.damping * momentum[i];
      const double reaction = net - force[i] - load[i];
      balance.unbalanced += net * net;
      balance.internal += force[i] * force[i];
      balance.external += load[i] * load[i] + reaction * reaction;
      balance.kinetic_energy += 0.5 * mass[i] * velocity[i] * velocity[i];
    }
  }
  return balance;
}

}  // namespace trajan
