#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/model/formula.h"
#include "solver/model/surface.h"
#include "solver/scene/boundaries.h"

/// Validated boundary conditions.
namespace trajan {

/// Nodes i0 <= i <= i1, j0 <= j <= j1, k0 <= k <= k1, and within the shape if there is one. Along a periodic axis
/// the last node of the grid is the first.
struct NodeRegion {
  std::int64_t i0 = 0, i1 = -1, j0 = 0, j1 = -1, k0 = 0, k1 = -1;
  std::optional<Region> shape;
};

/// Gives components of the velocity of nodes, or of the displacement that it is the rate of. Later ones win.
struct PrescribedMotion {
  NodeRegion nodes;
  bool displacement = false;
  VectorFormula components;  ///< an empty one is free
};

/// What touches a rigid plane (`ball` empty: beyond `point` against `normal`) or ball.
struct RigidObstacle {
  Vector point;   ///< of the plane, or the ball's centre, at time 0
  Vector normal;  ///< of the plane, of unit length
  double radius = 0;
  bool ball = false;
  double friction = 0;
  bool bonded = false;
  bool separates = true;
  VectorFormula displacement;  ///< of t
};

/// Holds components of the velocity of surface points, all of them or in the mean.
struct HeldSurface {
  std::vector<SurfacePoint> points;
  int normal = 0;  ///< axis
  bool mean = false;
  std::array<bool, 3> held{};
  VectorFormula displacement;  ///< of t
};

/// Dashpots.
struct AbsorbingSurface {
  std::vector<SurfacePoint> points;
  int normal = 0;                     ///< axis
  std::array<double, 3> impedance{};  ///< by axis, traction per velocity: density times wave speed
};

struct BoundaryCondition {
  std::string name;
  std::variant<PrescribedMotion, RigidObstacle, HeldSurface, AbsorbingSurface> kind;
};

}  // namespace trajan
