#include "solver/model/fields.h"

#include <array>

namespace trajan {

namespace {

constexpr std::array<std::string_view, 3> axes = {"x", "y", "z"};
constexpr std::array<std::string_view, 4> plane_tensor = {"xx", "yy", "xy", "zz"};
constexpr std::array<std::string_view, 6> solid_tensor = {"xx", "yy", "zz", "xy", "yz", "xz"};

std::span<const std::string_view> symmetric_tensor_components(Dimension dimension) {
  switch (dimension) {
    case Dimension::bar:
      return std::span(plane_tensor).first(1);
    case Dimension::plane_stress:
    case Dimension::plane_strain:
    case Dimension::axisymmetric:
      return plane_tensor;
    case Dimension::solid:
    case Dimension::unspecified:
      break;
  }
  return solid_tensor;
}

}  // namespace

std::span<const std::string_view> vector_components(Dimension dimension) {
  switch (dimension) {
    case Dimension::bar:
      return std::span(axes).first(1);
    case Dimension::plane_stress:
    case Dimension::plane_strain:
    case Dimension::axisymmetric:
      return std::span(axes).first(2);
    case Dimension::solid:
    case Dimension::unspecified:
      break;
  }
  return axes;
}

std::span<const std::string_view> field_components(Field field, Dimension dimension) {
  switch (field) {
    case Field::position:
    case Field::displacement:
    case Field::velocity:
      return vector_components(dimension);
    case Field::stress:
      return symmetric_tensor_components(dimension);
    case Field::unspecified:
      break;
  }
  return {};
}

std::string_view field_name(Field field) {
  switch (field) {
    case Field::position:
      return "position";
    case Field::displacement:
      return "displacement";
    case Field::velocity:
      return "velocity";
    case Field::stress:
      return "stress";
    case Field::unspecified:
      break;
  }
  return "unspecified";
}

}  // namespace trajan
