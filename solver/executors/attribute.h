#pragma once

#include <cstdint>

namespace trajan {

/// What a particle may carry, one array each. Only what a scene's kernels need is allocated.
enum class Attribute : std::uint8_t {
  position_x,  ///< where shape functions are evaluated: current, in total Lagrangian schemes reference
  position_y,
  position_z,
  velocity_x,
  velocity_y,
  velocity_z,
  displacement_x,  ///< total Lagrangian schemes: current minus reference position
  displacement_y,
  displacement_z,
  volume,     ///< current, thickness included, in axisymmetric scenes per radian
  stress_xx,  ///< Cauchy
  stress_yy,
  stress_zz,
  stress_xy,
  stress_yz,
  stress_xz,
  deformation_xx,  ///< deformation gradient F
  deformation_xy,
  deformation_xz,
  deformation_yx,
  deformation_yy,
  deformation_yz,
  deformation_zx,
  deformation_zy,
  deformation_zz,
  affine_xx,  ///< APIC: sum of velocity times distance from the particle
  affine_xy,
  affine_xz,
  affine_yx,
  affine_yy,
  affine_yz,
  affine_zx,
  affine_zy,
  affine_zz,
  history_0,  ///< what the law itself remembers, in the order that it states
  history_1,
  history_2,
  history_3,
  history_4,
  history_5,
  history_6,
  history_7,
  reference_volume,  ///< only where a body's particles differ in it; axisymmetric: per radian
  load_x,            ///< acceleration by loads that differ from particle to particle
  load_y,
  load_z,
  count
};
inline constexpr int most_history_variables = 8;
inline constexpr int attribute_count = static_cast<int>(Attribute::count);

}  // namespace trajan
