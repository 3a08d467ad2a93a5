#pragma once

#include "solver/simulation/executor.h"

namespace trajan {

/// Updated Lagrangian, stress updated first (Bardenhagen 2002): a step's stress comes from the velocities that
/// particles bring to the nodes when it begins. These belong to the middle of the step before, so that the
/// stress is one of the step's beginning; it is done when the step before ends, so that samples have it.
struct Usf {
  static constexpr std::string_view name = "USF";
  static constexpr bool total_lagrangian = false;

  static void step(Executor& mpm, const StepTimes& times) {
    mpm.particles({Pass::locate, Pass::force, Pass::scatter_state});
    mpm.update_velocities(times);
    mpm.particles({Pass::locate, Pass::update_velocity, Pass::gather_velocity, Pass::move});
    mpm.particles({Pass::locate, Pass::scatter_motion});
    mpm.map_velocities(true);
    mpm.particles({Pass::locate, Pass::gather_gradient, Pass::deform});
  }
};

}  // namespace trajan
