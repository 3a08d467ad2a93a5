#pragma once

#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "solver/schemes/kernels.h"

namespace trajan {

/// What a transfer does to a block in one pass, and what it gathers for that.
struct TransferPass {
  TransferPass() = default;
  TransferPass(std::initializer_list<Stage> in_order, std::initializer_list<NodeVector> gathers = {})
      : stages(in_order) {
    for (NodeVector vector : gathers) gathered |= 1u << vector;
  }
  std::vector<Stage> stages;
  unsigned gathered = 0;  ///< bits of node vectors
};

/// Which node vector is to be iterated on, sum_j (1 - S+ S)^j v.
struct Projection {
  NodeVector of = node_velocity;
  bool before_kick = false;      ///< not the velocity itself, but what it was before the kick
  std::vector<NodeVector> into;  ///< what further terms are added to; empty: there are none
};

struct TransferPasses {
  TransferPass begin;   ///< once, with the gradient of initial velocities in place of what particles carry of it
  TransferPass locate;  ///< besides what the shape functions do
  TransferPass scatter_state, scatter_momentum, update_velocity;
  /// Whether update_velocity leaves particles with the grid's velocity, so that nothing needs to gather it again.
  bool takes_grid_velocity = false;
  TransferPass kick;                ///< half a one, of particles alone, at a sample
  Projection projection;            ///< after a kick of the nodes
  Projection projection_at_sample;  ///< likewise at a sample
};

/// How particles and grid exchange velocities.
struct Transfer {
  std::string_view name;
  bool affine;       ///< particles carry velocities that vary linearly about them
  bool ordered;      ///< numerics.transfer_order is for it
  bool general;      ///< kernels that are but for FLIP will not do
  int node_vectors;  ///< that the grid needs
  TransferPasses (*passes)(const TransferKernels&, const MotionKernels&, const Numerics&);
  /// Why it is not sensible together with the rest of the numerics, of which all names are known; empty: it is.
  std::string_view (*objection)(const Numerics&);
};

/// The registered transfers, generated from the list in transfers/CMakeLists.txt.
std::span<const std::string_view> transfer_names();
/// nullptr: there is no transfer of that name.
const Transfer* find_transfer(std::string_view name);

}  // namespace trajan
