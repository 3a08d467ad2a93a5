#pragma once

#include <span>
#include <string_view>

#include "solver/scene/scene.h"

/// What fields are called, and the components that they have in each kind of scene.
namespace trajan {

/// In the order in which they are recorded. Vectors have the grid's axes: {"x"} in a bar, {"x", "y"} in
/// the plane and axisymmetric, {"x", "y", "z"} in a solid. Stresses are {"xx"}, {"xx", "yy", "xy", "zz"}
/// (axisymmetric: x is the radius, zz the hoop direction) and {"xx", "yy", "zz", "xy", "yz", "xz"}.
std::span<const std::string_view> field_components(Field field, Dimension dimension);

/// As in columns of histories and in result files.
std::string_view field_name(Field field);

/// The axes of vectors: field_components of a velocity.
std::span<const std::string_view> vector_components(Dimension dimension);

}  // namespace trajan
