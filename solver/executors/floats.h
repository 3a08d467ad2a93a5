#pragma once

#include "solver/executors/attribute.h"

/// What particles carry as floats where a scene asks for it: what has about the same relative error however small
/// it is. Places and volumes stay doubles, whose changes in a step may be a millionth of a millionth of them.
namespace trajan {

constexpr bool is_deformation(Attribute a) {
  return a >= Attribute::deformation_xx && a <= Attribute::deformation_zz;
}
/// What laws see of it.
constexpr bool is_float_of_law(Attribute a) {
  using enum Attribute;
  return (a >= stress_xx && a <= stress_xz) || is_deformation(a) || (a >= history_0 && a <= history_7);
}
constexpr bool may_be_float(Attribute a) {
  using enum Attribute;
  return is_float_of_law(a) || (a >= velocity_x && a <= velocity_z) || (a >= affine_xx && a <= affine_zz);
}
/// What is left out of an attribute that is a float: of deformation gradients the state at rest, so that strains
/// are known to the same share of them however small they are.
constexpr double value_at_rest(Attribute a) {
  return is_deformation(a) && (static_cast<int>(a) - static_cast<int>(Attribute::deformation_xx)) % 4 == 0 ? 1 : 0;
}

}  // namespace trajan
