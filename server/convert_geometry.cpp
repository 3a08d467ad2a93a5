#include "server/convert_parts.h"

namespace trajan {
namespace {

Dimension to_dimension(v1::Domain::Dimension value) {
  switch (value) {
    case v1::Domain::BAR:
      return Dimension::bar;
    case v1::Domain::PLANE_STRESS:
      return Dimension::plane_stress;
    case v1::Domain::PLANE_STRAIN:
      return Dimension::plane_strain;
    case v1::Domain::AXISYMMETRIC:
      return Dimension::axisymmetric;
    case v1::Domain::SOLID:
      return Dimension::solid;
    default:
      return Dimension::unspecified;
  }
}

}  // namespace

Vector to_vector(const v1::Vector& message) { return {message.x(), message.y(), message.z()}; }

VectorExpression to_vector_expression(const v1::VectorExpression& message) {
  VectorExpression expression;
  if (message.has_x()) expression.x = message.x();
  if (message.has_y()) expression.y = message.y();
  if (message.has_z()) expression.z = message.z();
  return expression;
}

Region to_region(const v1::Region& message) {
  switch (message.shape_case()) {
    case v1::Region::kBox:
      return Box{to_vector(message.box().lower()), to_vector(message.box().upper())};
    case v1::Region::kDisc:
      return Disc{to_vector(message.disc().centre()), message.disc().radius()};
    case v1::Region::SHAPE_NOT_SET:
      break;
  }
  return {};
}

Edge to_edge(int value) {
  switch (value) {
    case v1::LEFT:
      return Edge::left;
    case v1::RIGHT:
      return Edge::right;
    case v1::BOTTOM:
      return Edge::bottom;
    case v1::TOP:
      return Edge::top;
    case v1::BACK:
      return Edge::back;
    case v1::FRONT:
      return Edge::front;
    default:
      return Edge::unspecified;
  }
}

Surface to_surface(const v1::Surface& message) {
  Surface surface;
  surface.body = message.body();
  if (message.has_edge()) surface.part = to_edge(message.edge());
  if (message.has_rim()) surface.part = Disc{to_vector(message.rim().centre()), message.rim().radius()};
  surface.within = to_region(message.within());
  return surface;
}

Domain to_domain(const v1::Domain& message) {
  Domain domain;
  domain.dimension = to_dimension(message.dimension());
  domain.lower = to_vector(message.lower());
  domain.upper = to_vector(message.upper());
  domain.cell_size = message.cell_size();
  if (message.has_thickness()) domain.thickness = message.thickness();
  if (message.has_cross_section()) domain.cross_section = message.cross_section();
  return domain;
}

}  // namespace trajan
