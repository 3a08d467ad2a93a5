#pragma once

#include <string>
#include <variant>
#include <vector>

#include "solver/scene/geometry.h"

/// Boundary conditions, as scenes ask for them.
namespace trajan {

enum class Axis { unspecified, x, y, z };

struct Fixed {
  std::vector<Axis> axes;
};

struct Roller {
  Axis normal = Axis::unspecified;
};

struct Symmetry {
  Edge face = Edge::unspecified;
};

struct PrescribedVelocity {
  VectorExpression velocity;
};

struct PrescribedDisplacement {
  VectorExpression displacement;
};

struct Contact {
  double friction = 0;
  bool bonded = false;
  bool no_separation = false;
  VectorExpression displacement;
};

struct RigidPlane {
  Vector point;
  Vector normal;
  Contact contact;
};

struct RigidBall {
  Vector centre;
  double radius = 0;
  Contact contact;
};

enum class HingeKind { unspecified, whole, mean };

struct Hinge {
  Surface surface;
  HingeKind kind = HingeKind::unspecified;
  std::vector<Axis> axes;
  VectorExpression displacement;
};

struct Absorbing {
  Surface surface;
};

struct Periodic {
  Axis axis = Axis::unspecified;
};

/// `nodes`: those in a region or on a face of the domain; only conditions on nodes have it.
struct BoundaryDefinition {
  std::string name;
  std::variant<std::monostate, Region, Edge> nodes;
  std::variant<std::monostate, Fixed, PrescribedVelocity, PrescribedDisplacement, Roller, Symmetry, RigidPlane,
               RigidBall, Hinge, Absorbing, Periodic>
      condition;
};

}  // namespace trajan
