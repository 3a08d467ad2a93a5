#pragma once

#include "solver/schemes/usl.h"

namespace trajan {

/// Updated Lagrangian, stress update averaged (Nairn 2003): half of it last, by the step's velocities where they
/// are, half of it first in the next step, by what the moved particles bring to the nodes (see USF).
struct Usavg {
  static constexpr std::string_view name = "USAVG";
  static constexpr bool total_lagrangian = false;

  static void step(Executor& mpm, const StepTimes& times) {
    mpm.particles({Pass::locate, Pass::force, Pass::scatter_state});
    mpm.update_velocities(times, Usl::light_node);
    mpm.particles({Pass::locate, Pass::update_velocity});
    mpm.particles({Pass::gather_motion, Pass::move, Pass::deform_by_half});
    mpm.particles({Pass::locate, Pass::scatter_motion});
    mpm.map_velocities(true);
    mpm.particles({Pass::locate, Pass::gather_gradient, Pass::deform_by_half});
  }
};

}  // namespace trajan
