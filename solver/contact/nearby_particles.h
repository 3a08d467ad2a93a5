#pragma once

#include <vector>

#include "solver/contact/separating_plane.h"
#include "solver/executors/tiles.h"
#include "solver/simulation/particles.h"
#include "solver/surfaces/riders.h"

namespace trajan {

/// The particles of one field that are near a node: places in cells from the node, and who they are.
struct NearbyParticles {
  std::vector<Components> places;
  std::vector<Slot> particles;
  void clear() {
    places.clear();
    particles.clear();
  }
  void add(const Components& place, Slot particle) {
    places.push_back(place);
    particles.push_back(particle);
  }
};

/// How far from a node particles have a say in whether and how bodies touch there, in cells.
inline constexpr double nearby = 2;

/// Adds the particles of a tile's field to what is near the tile's nodes. `nodes`: bits of those that are asked
/// for; `near`: by node.
void find_nearby(const Tiles& tiles, const std::vector<BodyParticles>& bodies, const SweepConstants& sweep,
                 const Tile& tile, std::uint64_t nodes, std::vector<NearbyParticles*>& near);

/// How far a field reaches along a unit vector from a node, in cells: particles are ellipsoids within their
/// deformed cuboids. Of those that are not too far beside the vector, if there are some.
double reach(int axes, const std::vector<BodyParticles>& bodies, const NearbyParticles& near,
             const Components& along);

/// Whether some plane lies between the particles of two fields, which then do not touch. It is sought from the
/// given normal on where the convex hulls of their centres are closest (Gilbert 1966).
bool are_apart(int axes, const std::vector<BodyParticles>& bodies, const NearbyParticles& first,
               const NearbyParticles& second, const Components& normal);

}  // namespace trajan
