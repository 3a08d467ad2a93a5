#include "solver/model/fields.h"

#include <array>

namespace trajan {

namespace {

constexpr std::array<std::string_view, 3> axes = {"x", "y", "z"};
constexpr std::array<std::string_view, 4> plane_tensor = {"xx", "yy", "xy", "zz"};
constexpr std::array<std::string_view, 6> solid_tensor = {"xx", "yy", "zz", "xy", "yz", "xz"};
constexpr std::array<std::string_view, 3> bar_tensor = {"xx", "yy", "zz"};
constexpr std::array<std::string_view, 5> plane_gradient = {"xx", "xy", "yx", "yy", "zz"};
constexpr std::array<std::string_view, 9> solid_gradient = {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};

using Suffixes = std::span<const std::string_view>;

Suffixes components_of(Dimension dimension, Suffixes bar, Suffixes plane, Suffixes solid) {
  switch (dimension) {
    case Dimension::bar:
      return bar;
    case Dimension::plane_stress:
    case Dimension::plane_strain:
    case Dimension::axisymmetric:
      return plane;
    case Dimension::solid:
    case Dimension::unspecified:
      break;
  }
  return solid;
}

}  // namespace

std::span<const std::string_view> vector_components(Dimension dimension) {
  return components_of(dimension, std::span(axes).first(1), std::span(axes).first(2), axes);
}

std::span<const std::string_view> field_components(Field field, Dimension dimension) {
  switch (field) {
    case Field::position:
    case Field::displacement:
    case Field::velocity:
      return vector_components(dimension);
    case Field::stress:
      return components_of(dimension, std::span(bar_tensor).first(1), plane_tensor, solid_tensor);
    case Field::strain:
      return components_of(dimension, bar_tensor, plane_tensor, solid_tensor);
    case Field::deformation_gradient:
      return components_of(dimension, bar_tensor, plane_gradient, solid_gradient);
    case Field::pressure:
    case Field::von_mises_stress:
    case Field::history:
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
    case Field::strain:
      return "strain";
    case Field::deformation_gradient:
      return "deformation_gradient";
    case Field::pressure:
      return "pressure";
    case Field::von_mises_stress:
      return "von_mises_stress";
    case Field::history:
      return "history";
    case Field::unspecified:
      break;
  }
  return "unspecified";
}

}  // namespace trajan
