#pragma once

#include <cmath>
#include <cstddef>

#include "solver/model/components.h"

namespace trajan {

/// Where a rigid plane or ball is now.
struct RigidShape {
  Components point{};   ///< of the plane, or the ball's centre
  Components normal{};  ///< of the plane, outwards and of unit length
  bool ball = false;
  double radius = 0;
  Components period{};  ///< lengths after which the grid repeats itself; 0: it does not

  /// Outward normal, and how far outside a place is; < 0 within.
  double distance(const Components& at, Components& outwards) const {
    Components from;
    for (std::size_t axis = 0; axis < 3; ++axis) from[axis] = at[axis] - point[axis];
    if (!ball) {
      outwards = normal;
      return dot(from, normal);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (period[axis] > 0)
        from[axis] = std::remainder(from[axis], period[axis]);  // of all its images the nearest
    const double length = std::sqrt(dot(from, from));
    for (std::size_t axis = 0; axis < 3; ++axis) outwards[axis] = length > 0 ? from[axis] / length : 0;
    return length - radius;
  }
};

}  // namespace trajan
