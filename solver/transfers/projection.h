#pragma once

#include "solver/transfers/gather.h"
#include "solver/transfers/node_updates.h"
#include "solver/transfers/scatter.h"

/// One more term of sum_j (1 - S+ S)^j v, S the mapping of the grid to the particles and S+ the one back with
/// lumped masses (Hammerquist and Nairn 2017): a remainder r of the nodes' velocities becomes r - S+ S r.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <class Stencil, Layout L>
inline void gather_projected(Block& block) {
  gather<Stencil, L>(block, Gathered{node_projected_velocity, keep_in(scratch_of(block).velocity)});
}

template <class Stencil, Layout L>
inline void remap(Block& block) {
  RealArray* at_particles = scratch_of(block).velocity;
  gather<Stencil, L>(block, Gathered{node_remainder, keep_in(at_particles)});
  scatter_vector<Stencil, L>(block, sum_momentum, at_particles);
}

template <Layout L>
inline void reduce_remainder(NodeBlock& block) {
  alignas(64) double p[tile_nodes];
  const double* mass = block.nodes + tile_array(quantity_mass);
  for (int axis = 0; axis < L.dimensions; ++axis) {
    collect<L>(block.sums, quantity(sum_momentum, axis, L.dimensions), p);
    double* r = block.nodes + tile_array(quantity(node_remainder, axis, L.dimensions));
    for (int i = 0; i < tile_nodes; ++i) r[i] = mass[i] > block.least_mass ? r[i] - p[i] / mass[i] : 0;
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
