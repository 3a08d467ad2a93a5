#pragma once

#include <array>
#include <cstdint>

#include "solver/scene/geometry.h"

namespace trajan {

/// A quadrature point of a body's surface, which rides on a particle: what it does to the grid goes to the
/// particle's nodes by the polynomials that the shape functions are where it is, evaluated at the point. So
/// resultant and moment are exact, and no node without mass is touched.
struct SurfacePoint {
  std::int64_t carrier = 0;  ///< the particle's number
  Vector position;           ///< at time 0
  double area = 0;           ///< that it stands for, thickness included; axisymmetric: per radian
  /// Vectors along the surface whose product is outward normal times area without the thickness: in the
  /// plane the second is along z.
  std::array<Vector, 2> tangents{};
};

}  // namespace trajan
