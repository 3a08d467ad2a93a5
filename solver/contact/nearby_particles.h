#pragma once

#include <cmath>
#include <vector>

#include "solver/contact/body_surface.h"
#include "solver/contact/separating_plane.h"
#include "solver/executors/tiles.h"
#include "solver/simulation/particles.h"

namespace trajan {

/// The ellipsoid within a particle's deformed cuboid, in cells: E E^T of its half edges E, as xx, yy, zz, xy, yz,
/// xz.
using Ellipsoid = std::array<double, 6>;

Components product(const Ellipsoid& ellipsoid, const Components& vector);

/// A point of a field's surface near a node, in cells from there.
struct NearbyBoundary {
  Components place;
  Components normal;  ///< of unit length, outwards
};

/// The particles of one field that are near a node: places in cells from the node, and how far they reach from
/// there; and the field's surface.
struct NearbyParticles {
  std::vector<Components> places;
  std::vector<Ellipsoid> ellipsoids;
  std::vector<NearbyBoundary> boundary;
  void clear() {
    places.clear();
    ellipsoids.clear();
    boundary.clear();
  }
  void add(const Components& place, const Ellipsoid& ellipsoid) {
    places.push_back(place);
    ellipsoids.push_back(ellipsoid);
  }
  /// How far a particle reaches along a unit vector.
  double reach(std::size_t particle, const Components& along) const {
    return dot(places[particle], along) + std::sqrt(dot(along, product(ellipsoids[particle], along)));
  }
};

/// How far from a node particles have a say in whether and how bodies touch there, in cells.
inline constexpr double nearby = 2;
/// Cosine up to which a surface faces a direction: sides of a block's corner do not face what its foot does.
inline constexpr double facing = 0.5;
/// In cells: what lies deeper behind the foremost point of a surface is no part of it.
inline constexpr double layer = 0.75;
/// In cells from the line along the normal: what says how wide the gap is. Of every body some points, however few
/// particles it has in a cell, and no more: means over curved gaps, as at a contact's end, make contacts narrower.
inline constexpr double beside = 0.75;

/// Of what is this far away, squared: falls smoothly to zero.
inline double falling_weight(double square, double furthest) {
  const double share = 1 - square / (furthest * furthest);
  return share > 0 ? share * share : 0;
}

/// Adds the particles of a tile's field to what is near the tile's nodes. `nodes`: bits of those that are asked
/// for; `near`: by node.
void find_nearby(const Tiles& tiles, const std::vector<BodyParticles>& bodies,
                 const std::vector<BodySurface>& surfaces, const SweepConstants& sweep, const Tile& tile,
                 std::uint64_t nodes, std::vector<NearbyParticles*>& near);

/// How far a field reaches along a unit vector from a node, in cells. Of those that are not too far beside the
/// vector, if there are some.
double reach(const NearbyParticles& near, const Components& along);

}  // namespace trajan
