#pragma once

#include <cstdint>

namespace trajan {

/// What can be done to a block of particles.
enum class Pass {
  begin,             ///< what the transfer makes of initial velocities
  locate,            ///< cell and place in it
  force,             ///< stress to forces, by the body's law
  scatter_state,     ///< mass, momentum, forces and loads to the nodes
  update_velocity,   ///< from the nodes, as the scene's transfer does
  kick,              ///< by acceleration alone
  remap,             ///< what the nodes have to the particles, and its momentum back
  scatter_momentum,  ///< to the nodes, a second time
  scatter_motion,    ///< mass and momentum alone, of particles that have moved
  gather_velocity,   ///< of the grid
  gather_gradient,   ///< of the velocity that is for gradients
  gather_motion,     ///< both
  move,              ///< positions
  displace,          ///< displacements, positions being reference ones
  deform,            ///< deformation and stress, by the body's law
  deform_by_half     ///< the same for half the step
};

/// When a kick happens and how far velocities and positions go.
struct StepTimes {
  std::int64_t step = 0;
  double time = 0;    ///< of positions and forces
  double before = 0;  ///< of velocities before the kick
  double after = 0;   ///< of velocities after it
  double drift = 0;   ///< time step of the positions; 0 at a sample, where velocities catch up with them
  double kick() const { return after - before; }
};

}  // namespace trajan
