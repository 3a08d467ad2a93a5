#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/contact/separating_plane.h"
#include "solver/model/model.h"

namespace trajan {

/// A point of a body's surface that moves with a particle nearby, in the body's stress-free state.
struct BoundaryPoint {
  Components from;    ///< from the particle, in cells
  Components normal;  ///< outwards
};

/// Where the surface of a body lies that particles fill in steps: behind every side of a particle's cuboid without
/// another particle, the point of the geometry's boundary that is nearest to the middle of that side.
class BodySurface {
 public:
  BodySurface(const Model& model, const Body& body);
  /// The points that move with a particle, by its number within the body.
  std::span<const BoundaryPoint> of(std::uint32_t particle) const {
    const auto i = static_cast<std::size_t>(particle);
    return std::span(points_).subspan(first_[i], first_[i + 1] - first_[i]);
  }

 private:
  std::vector<BoundaryPoint> points_;
  std::vector<std::uint32_t> first_;  ///< by particle, and one more
};

}  // namespace trajan
