#pragma once

#include "solver/simulation/executor.h"

namespace trajan {

/// Total Lagrangian (de Vaucorbeil, Nguyen and Hutchinson 2020; Asiri 2022, algorithm 2): as MUSL, with
/// shape functions of the reference positions, the first Piola-Kirchhoff stress and the gradient Fdot.
struct Tlmpm {
  static constexpr std::string_view name = "TLMPM";
  static constexpr bool total_lagrangian = true;

  static void step(Executor& mpm, const StepTimes& times) {
    mpm.particles({Pass::locate, Pass::force, Pass::scatter_state});
    mpm.update_velocities(times);
    mpm.particles({Pass::locate, Pass::update_velocity, Pass::scatter_momentum});
    mpm.map_velocities();
    mpm.particles({Pass::locate, Pass::gather_motion, Pass::displace, Pass::deform});
  }
};

}  // namespace trajan
