#pragma once

#include "solver/simulation/executor.h"

namespace trajan {

/// Updated Lagrangian, modified update stress last (Sulsky, Zhou and Schreyer 1995; Asiri 2022,
/// algorithm 1): the gradient is of velocities that are mapped to the nodes a second time.
struct Musl {
  static constexpr std::string_view name = "MUSL";
  static constexpr bool total_lagrangian = false;

  static void step(Executor& mpm, const StepTimes& times) {
    mpm.particles({Pass::locate, Pass::force, Pass::scatter_state});
    mpm.update_velocities(times);
    mpm.particles({Pass::locate, Pass::update_velocity, Pass::scatter_momentum});
    mpm.map_velocities();
    mpm.particles({Pass::locate, Pass::gather_motion, Pass::move, Pass::deform});
  }
};

}  // namespace trajan
