#pragma once

#include "solver/simulation/executor.h"

namespace trajan {

/// Updated Lagrangian, stress updated last (Sulsky, Chen and Schreyer 1994).
struct Usl {
  static constexpr std::string_view name = "USL";
  static constexpr bool total_lagrangian = false;

  static void step(Executor& mpm, const StepTimes& times) {
    mpm.particles({Pass::locate, Pass::force, Pass::scatter_state});
    mpm.update_velocities(times);
    mpm.particles({Pass::locate, Pass::gather_acceleration, Pass::update_velocity});
    mpm.particles({Pass::gather_motion, Pass::move, Pass::deform});
  }
};

}  // namespace trajan
