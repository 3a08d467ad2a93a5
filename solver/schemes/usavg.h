#pragma once

#include "solver/simulation/executor.h"

namespace trajan {

/// Updated Lagrangian, stress update averaged (Nairn 2003): half of it where particles are when the step begins,
/// as in MUSL, half where they are when it ends, as in USF, both by velocities that particles have brought to the
/// nodes. Each half by itself errs by the first power of the step, to the other side than the other half: MUSL
/// makes energy of smooth functions' gradients, which change under moving particles, in proportion to the square
/// of the step, and this does not (tests/stability: long_runs).
struct Usavg {
  static constexpr std::string_view name = "USAVG";
  static constexpr bool total_lagrangian = false;

  static void step(Executor& mpm, const StepTimes& times) {
    mpm.particles({Pass::locate, Pass::force, Pass::scatter_state});
    mpm.update_velocities(times);
    mpm.particles({Pass::locate, Pass::update_velocity, Pass::scatter_momentum});
    mpm.map_velocities();
    mpm.particles({Pass::locate, Pass::gather_motion, Pass::move, Pass::deform_by_half});
    mpm.particles({Pass::locate, Pass::scatter_motion});
    mpm.map_velocities(true);
    mpm.particles({Pass::locate, Pass::gather_gradient, Pass::deform_by_half});
  }
};

}  // namespace trajan
