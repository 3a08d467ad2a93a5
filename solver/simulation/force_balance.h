#pragma once

#include "solver/schemes/kernels.h"

namespace trajan {

/// What the forces on the nodes amount to, sums of squares over nodes and components.
struct ForceBalance {
  double unbalanced = 0;  ///< internal forces, loads and reactions together
  double internal = 0;    ///< internal forces
  double external = 0;    ///< loads and reactions, each by itself
  double power = 0;       ///< of unbalanced forces, with the velocities before the kick
  ForceBalance& operator+=(const ForceBalance& other) {
    unbalanced += other.unbalanced;
    internal += other.internal;
    external += other.external;
    power += other.power;
    return *this;
  }
};

/// Of a tile's nodes once their accelerations are final. What conditions have added to these are reactions.
ForceBalance force_balance(const NodeBlock& block, int axes);

/// Whether forces that matter act on nodes of a tile that are too light to move. Particles that lie exactly on a
/// face of cells at a body's surface give the nodes beyond it no mass, but, where functions have kinks at faces, a
/// share of their stress.
bool has_unborne_forces(const NodeBlock& block, int axes);

}  // namespace trajan
