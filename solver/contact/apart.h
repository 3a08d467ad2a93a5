#pragma once

#include "solver/contact/nearby_particles.h"

namespace trajan {

/// Whether some plane lies between the particles of two fields, which then do not touch: whether the difference of
/// their convex hulls lacks the origin (Gilbert, Johnson and Keerthi 1988), whose nearest point is found by
/// Wolfe's method (1976). Gaps of less than a millionth of a cell are none. Neither field may be empty.
bool are_apart(int axes, const NearbyParticles& first, const NearbyParticles& second);

}  // namespace trajan
