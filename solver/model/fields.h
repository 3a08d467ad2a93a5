#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/scene/scene.h"

/// What fields are called, and the components that they have in each kind of scene.
namespace trajan {

/// In the order in which they are recorded; none: the field is a number. Vectors have the grid's axes: {"x"}
/// in a bar, {"x", "y"} in the plane and axisymmetric, {"x", "y", "z"} in a solid. Stress and strain have
/// {"xx", "yy", "xy", "zz"} (axisymmetric: x is the radius, zz the hoop direction), in a solid {"xx", "yy",
/// "zz", "xy", "yz", "xz"}, in a bar stress {"xx"} and strain {"xx", "yy", "zz"}; the deformation gradient has
/// {"xx", "xy", "yx", "yy", "zz"}, in a solid nine row by row, in a bar {"xx", "yy", "zz"}.
std::span<const std::string_view> field_components(Field field, Dimension dimension);

/// As in columns of histories and in result files.
std::string_view field_name(Field field);

/// The axes of vectors: field_components of a velocity.
std::span<const std::string_view> vector_components(Dimension dimension);

/// A field as probes and snapshots record it, in columns and files by its name.
struct RecordedField {
  Field field = Field::unspecified;
  std::string name;
  std::span<const std::string_view> components;  ///< none: a number
  /// Field::history: by body, which of its law's history variables has this name; -1: none.
  std::vector<int> history;

  std::size_t width() const { return components.empty() ? 1 : components.size(); }
};

}  // namespace trajan
