#pragma once

#include "solver/simulation/executor.h"

namespace trajan {

/// Updated Lagrangian, stress updated last (Sulsky, Chen and Schreyer 1994). A node that particles hardly
/// reach has next to no mass but a whole force, and its velocity after the kick would tear them apart: below a
/// cut-off mass (as Sulsky, Zhou and Schreyer 1995 discuss) the gradient takes the velocity before the kick
/// instead, which schemes that update stress first do everywhere (Bardenhagen 2002). Momentum is not touched.
struct Usl {
  static constexpr std::string_view name = "USL";
  static constexpr bool total_lagrangian = false;

  /// Of a particle's mass. Colliding discs are alike for any value from 0.1 to 1; a small one leaves more
  /// nodes to leapfrog, which keeps the energy of those that stay light.
  static constexpr double light_node = 0.1;

  static void step(Executor& mpm, const StepTimes& times) {
    mpm.particles({Pass::locate, Pass::force, Pass::scatter_state});
    mpm.update_velocities(times, light_node);
    mpm.particles({Pass::locate, Pass::update_velocity});
    mpm.particles({Pass::gather_motion, Pass::move, Pass::deform});
  }
};

}  // namespace trajan
