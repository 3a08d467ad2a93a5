#pragma once

#include "solver/transfers/transfer.h"

namespace trajan {

/// Full mass matrix of order k (Nairn 2021): the nodes' velocities are k terms of the series
/// sum_j (1 - S+ S)^j v, which approaches what the consistent mass matrix makes of the same momenta, and
/// particles take them on. Order 1 is PIC. Positions and gradients follow the same velocities; what a scheme
/// maps a second time has lumped masses.
struct Fmpm {
  static constexpr std::string_view name = "FMPM";
  static constexpr bool affine = false, ordered = true, general = true;
  static constexpr int needed_vectors = node_remainder + 1;

  static TransferPasses passes(const TransferKernels& kernels, const MotionKernels& motion, const Numerics&) {
    TransferPasses passes;
    passes.scatter_state = {kernels.scatter_state};
    passes.scatter_momentum = {kernels.scatter_momentum};
    passes.update_velocity = {{kernels.gather_velocity, motion.take_velocity}, {node_velocity}};
    passes.kick = {{kernels.gather_acceleration, motion.kick}, {node_acceleration}};
    passes.projection = {node_velocity, false, {node_velocity, node_mapped_velocity}};
    passes.projection_at_sample = {node_acceleration, false, {node_acceleration}};
    return passes;
  }
  static std::string_view objection(const Numerics&) { return {}; }
};

}  // namespace trajan
