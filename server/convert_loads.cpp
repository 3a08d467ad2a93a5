#include "server/convert_parts.h"

namespace trajan {
namespace {

TimeFunctionDefinition to_time_function(const v1::TimeFunction& message) {
  switch (message.kind_case()) {
    case v1::TimeFunction::kConstant:
      return message.constant();
    case v1::TimeFunction::kRamp:
      return Ramp{message.ramp().start(), message.ramp().duration(), message.ramp().smooth()};
    case v1::TimeFunction::kSine:
      return Sine{message.sine().frequency(), message.sine().phase()};
    case v1::TimeFunction::kTable:
      return Table{{message.table().times().begin(), message.table().times().end()},
                   {message.table().values().begin(), message.table().values().end()}};
    case v1::TimeFunction::kExpression:
      return message.expression();
    case v1::TimeFunction::KIND_NOT_SET:
      break;
  }
  return LoadDefinition{}.time;
}

PointForce to_point_force(const v1::PointForce& message) {
  return {message.body(), to_vector(message.position()), to_vector(message.force())};
}

EdgeTraction to_edge_traction(const v1::EdgeTraction& message) {
  return {message.body(), to_edge(message.edge()), to_vector(message.traction()), message.profile(),
          to_region(message.within())};
}

Pressure to_pressure(const v1::Pressure& message) {
  return {to_surface(message.surface()), message.pressure(), message.profile(),
          message.configuration() != v1::Pressure::REFERENCE};
}

BodyForce to_body_force(const v1::BodyForce& message) {
  return {to_vector(message.acceleration()),
          {message.bodies().begin(), message.bodies().end()},
          to_vector_expression(message.field()),
          message.configuration() == v1::BodyForce::REFERENCE};
}

}  // namespace

LoadDefinition to_load(const v1::Load& message) {
  LoadDefinition load;
  load.name = message.name();
  load.time = to_time_function(message.time());
  switch (message.kind_case()) {
    case v1::Load::kPointForce:
      load.kind = to_point_force(message.point_force());
      break;
    case v1::Load::kEdgeTraction:
      load.kind = to_edge_traction(message.edge_traction());
      break;
    case v1::Load::kBodyForce:
      load.kind = to_body_force(message.body_force());
      break;
    case v1::Load::kPressure:
      load.kind = to_pressure(message.pressure());
      break;
    case v1::Load::KIND_NOT_SET:
      break;
  }
  return load;
}

}  // namespace trajan
