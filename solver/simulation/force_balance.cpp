#include "solver/simulation/force_balance.h"

#include <algorithm>
#include <cmath>

namespace trajan {

ForceBalance force_balance(const NodeBlock& block, int axes) {
  ForceBalance balance;
  const NodeSums& sums = *block.collected;
  const double* mass = block.nodes + tile_array(quantity_mass);
  for (int axis = 0; axis < axes; ++axis) {
    const double* force = sums.values[quantity(sum_force, axis, axes)];
    const double* load = sums.values[quantity(sum_load, axis, axes)];
    const double* momentum = sums.values[quantity(sum_momentum, axis, axes)];
    const double* acceleration = block.nodes + tile_array(quantity(node_acceleration, axis, axes));
    for (int i = 0; i < tile_nodes; ++i) {
      if (!(mass[i] > block.least_mass)) continue;
      const double net = mass[i] * acceleration[i] + block.damping * momentum[i];
      const double reaction = net - force[i] - load[i];
      balance.unbalanced += net * net;
      balance.internal += force[i] * force[i];
      balance.external += load[i] * load[i] + reaction * reaction;
      balance.power += net * momentum[i] / mass[i];
    }
  }
  return balance;
}

bool has_unborne_forces(const NodeBlock& block, int axes) {
  // What smooth functions leave to nodes of next to no mass is next to no force.
  constexpr double negligible = 1e-6;
  const NodeSums& sums = *block.collected;
  const double* mass = block.nodes + tile_array(quantity_mass);
  double unborne = 0, borne = 0;
  for (int axis = 0; axis < axes; ++axis) {
    const double* force = sums.values[quantity(sum_force, axis, axes)];
    const double* load = sums.values[quantity(sum_load, axis, axes)];
    for (int i = 0; i < tile_nodes; ++i) {
      double& largest = mass[i] > block.least_mass ? borne : unborne;
      largest = std::max(largest, std::abs(force[i]) + std::abs(load[i]));
    }
  }
  return unborne > negligible * borne;
}

}  // namespace trajan
