#pragma once

#include "solver/contact/nearby_particles.h"

namespace trajan {

/// Whether a slab of this thickness, in cells, lies between the particles and surfaces of two fields, which then
/// do not touch: whether the difference of their convex hulls keeps that far from the origin (Gilbert, Johnson and
/// Keerthi 1988), to which the nearest point is found by Wolfe's method (1976). Neither field may be empty.
bool are_apart(int axes, const NearbyParticles& first, const NearbyParticles& second, double by);

}  // namespace trajan
