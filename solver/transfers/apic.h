#pragma once

#include "solver/schemes/schemes.h"
#include "solver/transfers/transfer.h"

namespace trajan {

/// Affine particle-in-cell (Jiang et al. 2015; Jiang, Schroeder and Teran 2017): particles take on the grid's
/// velocity and how it varies about them, which keeps angular momentum. Where a scheme maps momentum a second
/// time it is that of the whole affine velocities too: without the second part the gradients of a rotating body
/// would not be those of the rotation. Half kicks at samples change both parts, so that the two halves are one.
struct Apic {
  static constexpr std::string_view name = "APIC";
  static constexpr bool affine = true, ordered = false, general = true;
  static constexpr int needed_vectors = node_vectors;

  static TransferPasses passes(const TransferKernels& kernels, const MotionKernels& motion, const Numerics&) {
    const AffineKernels& stages = kernels.affine;
    TransferPasses passes;
    passes.begin = {stages.begin};
    passes.locate = {stages.find_levers};
    passes.scatter_state = {stages.scatter_state};
    passes.scatter_momentum = {stages.scatter_momentum};
    passes.update_velocity = {{stages.gather, motion.take_velocity}, {node_velocity}};
    passes.takes_grid_velocity = true;
    passes.kick = {{stages.kick, motion.kick}, {node_acceleration}};
    return passes;
  }
  static std::string_view objection(const Numerics& numerics) {
    if (numerics.shape_functions == "cpdi") return "APIC needs shape functions that are products along the axes";
    // There D is zero, and the nodes beyond a free surface would take on angular momentum with no inertia.
    const Scheme* scheme = find_scheme(numerics.scheme);
    if (numerics.shape_functions == "linear" && scheme && !scheme->total_lagrangian)
      return "APIC cannot carry particles past nodes by linear functions: there they turn nothing but one node";
    return {};
  }
};

}  // namespace trajan
