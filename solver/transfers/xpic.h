#pragma once

#include "solver/transfers/transfer.h"

namespace trajan {

/// Extended particle-in-cell of order m (Hammerquist and Nairn 2017): FLIP, but of the particles' velocities
/// only that is kept which the grid can see, (1 - (1 - S S+)^m) v + dt S a. On the nodes this is the sum of
/// (1 - S+ S)^j v for j < m with v before the kick, plus dt a. Order 1 is PIC. Positions and gradients follow
/// the grid's velocity.
struct Xpic {
  static constexpr std::string_view name = "XPIC";
  static constexpr bool affine = false, ordered = true, general = true;
  static constexpr int needed_vectors = node_projected_velocity + 1;

  static TransferPasses passes(const TransferKernels& kernels, const MotionKernels& motion, const Numerics&) {
    TransferPasses passes;
    passes.scatter_state = {kernels.scatter_state};
    passes.scatter_momentum = {kernels.scatter_momentum};
    passes.update_velocity = {{kernels.gather_projected, motion.take_velocity}, {node_projected_velocity}};
    passes.kick = {{kernels.gather_acceleration, motion.kick}, {node_acceleration}};
    passes.projection = {node_velocity, true, {node_projected_velocity}};
    return passes;
  }
  static std::string_view objection(const Numerics&) { return {}; }
};

}  // namespace trajan
