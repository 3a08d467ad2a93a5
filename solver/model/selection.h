#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "solver/model/geometry.h"
#include "solver/model/model.h"

/// Which particles of a body a place or a region means. Particles are meant by their numbers; nothing
/// here takes memory or time that grows with the particles of a body beyond those selected and, for a
/// disc, its rows.
namespace trajan {

struct NearestParticle {
  std::int64_t particle = 0;
  double distance = 0;
  double rows = 0;  ///< that were looked at, which is what the search costs
};

/// The particle whose reference position is nearest to `place`; of equals (to 1e-9 spacings) the first.
/// Precondition: the body has particles.
NearestParticle nearest_particle(const Body& body, Vector place);

/// The number of the particle in this column of this row of a box.
std::int64_t box_particle(const Body& body, std::int64_t column, std::int64_t row);

/// At least the number of particles that `particles_in` would return; from arithmetic alone.
double most_particles_in(const Body& body, const Region& region);

/// Appends the numbers of the particles whose reference positions lie in the region, ascending.
void particles_in(const Body& body, const Region& region, std::vector<std::int64_t>& particles);

}  // namespace trajan
