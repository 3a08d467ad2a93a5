#include "server/convert_parts.h"

namespace trajan {
namespace {

Axis to_axis(int value) {
  switch (value) {
    case v1::Fixed::X:
      return Axis::x;
    case v1::Fixed::Y:
      return Axis::y;
    case v1::Fixed::Z:
      return Axis::z;
    default:
      return Axis::unspecified;
  }
}

}  // namespace

BoundaryDefinition to_boundary(const v1::Boundary& message) {
  BoundaryDefinition boundary;
  boundary.name = message.name();
  boundary.nodes = to_region(message.nodes());
  switch (message.condition_case()) {
    case v1::Boundary::kFixed:
      boundary.condition = Fixed{convert_all(message.fixed().axes(), to_axis)};
      break;
    case v1::Boundary::kPrescribedVelocity:
      boundary.condition = PrescribedVelocity{to_vector_expression(message.prescribed_velocity().velocity())};
      break;
    case v1::Boundary::CONDITION_NOT_SET:
      break;
  }
  return boundary;
}

}  // namespace trajan
