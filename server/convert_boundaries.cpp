#include "server/convert_parts.h"

namespace trajan {
namespace {

Axis to_axis(int value) {
  switch (value) {
    case v1::X:
      return Axis::x;
    case v1::Y:
      return Axis::y;
    case v1::Z:
      return Axis::z;
    default:
      return Axis::unspecified;
  }
}

Contact to_contact(const v1::Contact& message) {
  return {message.friction(), message.bonded(), message.no_separation(),
          to_vector_expression(message.displacement())};
}

HingeKind to_hinge_kind(v1::Hinge::Kind value) {
  switch (value) {
    case v1::Hinge::WHOLE:
      return HingeKind::whole;
    case v1::Hinge::MEAN:
      return HingeKind::mean;
    default:
      return HingeKind::unspecified;
  }
}

Hinge to_hinge(const v1::Hinge& message) {
  return {to_surface(message.surface()), to_hinge_kind(message.kind()), convert_all(message.axes(), to_axis),
          to_vector_expression(message.displacement())};
}

decltype(BoundaryDefinition::condition) to_condition(const v1::Boundary& message) {
  switch (message.condition_case()) {
    case v1::Boundary::kFixed:
      return Fixed{convert_all(message.fixed().axes(), to_axis)};
    case v1::Boundary::kRoller:
      return Roller{to_axis(message.roller().normal())};
    case v1::Boundary::kSymmetry:
      return Symmetry{to_edge(message.symmetry().face())};
    case v1::Boundary::kPrescribedVelocity:
      return PrescribedVelocity{to_vector_expression(message.prescribed_velocity().velocity())};
    case v1::Boundary::kPrescribedDisplacement:
      return PrescribedDisplacement{to_vector_expression(message.prescribed_displacement().displacement())};
    case v1::Boundary::kRigidPlane:
      return RigidPlane{to_vector(message.rigid_plane().point()), to_vector(message.rigid_plane().normal()),
                        to_contact(message.rigid_plane().contact())};
    case v1::Boundary::kRigidBall:
      return RigidBall{to_vector(message.rigid_ball().centre()), message.rigid_ball().radius(),
                       to_contact(message.rigid_ball().contact())};
    case v1::Boundary::kHinge:
      return to_hinge(message.hinge());
    case v1::Boundary::kAbsorbing:
      return Absorbing{to_surface(message.absorbing().surface())};
    case v1::Boundary::kPeriodic:
      return Periodic{to_axis(message.periodic().axis())};
    case v1::Boundary::CONDITION_NOT_SET:
      break;
  }
  return {};
}

}  // namespace

BoundaryDefinition to_boundary(const v1::Boundary& message) {
  BoundaryDefinition boundary;
  boundary.name = message.name();
  if (message.has_nodes()) boundary.nodes = to_region(message.nodes());
  if (message.has_face()) boundary.nodes = to_edge(message.face());
  boundary.condition = to_condition(message);
  return boundary;
}

}  // namespace trajan
