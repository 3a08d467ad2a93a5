#pragma once

#include <optional>

#include "solver/contact/nearby_particles.h"

namespace trajan {

/// How the surfaces of two fields lie to each other near a node: the mean over what they have within two cells,
/// with weights that fall to zero there, so that surfaces that bend are further apart by less than a third of a
/// cell squared over each one's radius.
struct Meeting {
  Components normal{};  ///< of unit length, out of the first into the second
  double gap = 0;       ///< in cells; negative: they overlap
};

/// By the boundaries that both bodies began with, or where one of them has none, since it has torn, by its
/// particles. Nothing if they are apart by more than `by` cells. Neither field may be empty.
std::optional<Meeting> meeting(int axes, const NearbyParticles& first, const NearbyParticles& second, double by);

}  // namespace trajan
