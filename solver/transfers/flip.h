#pragma once

#include "solver/transfers/transfer.h"

namespace trajan {

/// Particles take on the grid's acceleration, v + dt a (Brackbill and Ruppel 1986), or a blend of that and the
/// grid's velocity, of which nothing else is left as PIC (Stomakhin et al. 2013).
struct Flip {
  static constexpr std::string_view name = "FLIP";
  static constexpr bool affine = false, ordered = false, general = false;
  static constexpr int needed_vectors = node_vectors;

  static TransferPasses passes(const TransferKernels& kernels, const MotionKernels& motion,
                               const Numerics& numerics) {
    TransferPasses passes;
    passes.scatter_state = {kernels.scatter_state};
    passes.scatter_momentum = {kernels.scatter_momentum};
    passes.kick = {{kernels.gather_acceleration, motion.kick}, {node_acceleration}};
    passes.update_velocity = passes.kick;
    if (numerics.flip_fraction.value_or(1) < 1)
      passes.update_velocity = {{kernels.gather_acceleration, kernels.gather_velocity, motion.kick_and_blend},
                                {node_acceleration, node_velocity}};
    return passes;
  }
  static std::string_view objection(const Numerics&) { return {}; }
};

}  // namespace trajan
