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

Part to_part(const v1::Region& message) { return {to_region(message)}; }

std::optional<std::string> given(bool is_given, const std::string& text) {
  return is_given ? std::optional(text) : std::nullopt;
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

SymmetricTensorExpression to_symmetric_tensor_expression(const v1::SymmetricTensorExpression& m) {
  return {{given(m.has_xx(), m.xx()), given(m.has_yy(), m.yy()), given(m.has_zz(), m.zz()),
           given(m.has_xy(), m.xy()), given(m.has_yz(), m.yz()), given(m.has_xz(), m.xz())}};
}

TensorExpression to_tensor_expression(const v1::TensorExpression& m) {
  return {{given(m.has_xx(), m.xx()), given(m.has_xy(), m.xy()), given(m.has_xz(), m.xz()),
           given(m.has_yx(), m.yx()), given(m.has_yy(), m.yy()), given(m.has_yz(), m.yz()),
           given(m.has_zx(), m.zx()), given(m.has_zy(), m.zy()), given(m.has_zz(), m.zz())}};
}

Region to_region(const v1::Region& message) {
  switch (message.shape_case()) {
    case v1::Region::kBox:
      return Box{to_vector(message.box().lower()), to_vector(message.box().upper())};
    case v1::Region::kDisc:
      return Disc{to_vector(message.disc().centre()), message.disc().radius()};
    case v1::Region::kSphere:
      return Sphere{to_vector(message.sphere().centre()), message.sphere().radius()};
    case v1::Region::kCylinder:
      return Cylinder{to_vector(message.cylinder().from()), to_vector(message.cylinder().to()),
                      message.cylinder().radius()};
    case v1::Region::kPolygon:
      return Polygon{convert_all(message.polygon().corners(), to_vector)};
    case v1::Region::kMesh:
      return Mesh{message.mesh().stl()};
    case v1::Region::kUnion:
      return Union{convert_all(message.union_().regions(), to_part)};
    case v1::Region::kIntersection:
      return Intersection{convert_all(message.intersection().regions(), to_part)};
    case v1::Region::kDifference:
      return Difference{convert_all(message.difference().regions(), to_part)};
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
