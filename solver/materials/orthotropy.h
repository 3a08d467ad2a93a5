#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/materials/dimension.h"
#include "solver/materials/eigenvalues.h"
#include "solver/materials/material.h"
#include "solver/materials/tensor_inverse.h"
#include "solver/materials/tensor_products.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

constexpr Parameter orthotropic_modulus(std::string_view name, std::string_view meaning) {
  return {.name = name, .unit = "stress", .meaning = meaning, .lowest = 0, .highest = 1e300};
}
constexpr Parameter orthotropic_ratio(std::string_view name, std::string_view meaning) {
  return {.name = name, .unit = "1", .meaning = meaning, .lowest = -1e3, .highest = 1e3};
}
constexpr Parameter frame_angle(std::string_view name, std::string_view meaning) {
  return {.name = name, .unit = "radians", .meaning = meaning, .lowest = -1e3, .highest = 1e3, .otherwise = 0};
}

inline constexpr Parameter orthotropy_parameters[] = {
    orthotropic_modulus("youngs_modulus_1", "Young's modulus along the material's axis 1"),
    orthotropic_modulus("youngs_modulus_2", "Young's modulus along the material's axis 2"),
    orthotropic_modulus("youngs_modulus_3", "Young's modulus along the material's axis 3"),
    orthotropic_ratio("poissons_ratio_12", "contraction along 2 by tension along 1"),
    orthotropic_ratio("poissons_ratio_23", "contraction along 3 by tension along 2"),
    orthotropic_ratio("poissons_ratio_31", "contraction along 1 by tension along 3"),
    orthotropic_modulus("shear_modulus_12", "shear modulus of axes 1 and 2"),
    orthotropic_modulus("shear_modulus_23", "shear modulus of axes 2 and 3"),
    orthotropic_modulus("shear_modulus_31", "shear modulus of axes 3 and 1"),
    frame_angle("angle_z", "angle by which the material's axes are turned about z, last"),
    frame_angle("angle_y", "angle by which the material's axes are turned about y, before that"),
    frame_angle("angle_x", "angle by which the material's axes are turned about x, first")};

/// Stiffness in the material's axes. Shear: 12, 23, 31.
struct OrthotropicStiffness {
  double normal[3][3];
  double shear[3];
};

/// Compliance of the normal components: e_i = s_i / E_i - nu_ij / E_i s_j (Jones 1999, eq. 2.25).
inline SymmetricTensor<3> normal_compliance(const double* v) {
  return {{1 / v[0], 1 / v[1], 1 / v[2]}, {-v[3] / v[0], -v[4] / v[1], -v[5] / v[2]}};
}

inline OrthotropicStiffness orthotropic_stiffness(const double* v) {
  const SymmetricTensor<3> normal = inverse(normal_compliance(v));
  OrthotropicStiffness c{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) c.normal[i][j] = normal(i, j);
  std::copy(v + 6, v + 9, c.shear);
  return c;
}

/// Positive definite if its leading minors are.
inline Objection check_orthotropy(const double* v, Dimension dimension) {
  const SymmetricTensor<3> s = normal_compliance(v);
  // Without the scale of the moduli, which may be extreme.
  const double a = s(0, 1) * s(0, 1) * v[0] * v[1], b = s(1, 2) * s(1, 2) * v[1] * v[2],
               c = s(0, 2) * s(0, 2) * v[0] * v[2];
  const double rest = 1 - a - b - c + 2 * s(0, 1) * s(1, 2) * s(0, 2) * v[0] * v[1] * v[2];
  if (!(a < 1 && b < 1 && c < 1 && rest > 0))
    return {"Young's moduli and Poisson's ratios together give no positive strain energy",
            "give poissons_ratio_ij^2 < youngs_modulus_i / youngs_modulus_j and smaller ratios together"};
  if (dimension == Dimension::bar && (v[9] != 0 || v[10] != 0 || v[11] != 0))
    return {"a bar of a material that is turned would shear", "leave out the angles in a bar"};
  if (dimension != Dimension::solid && (v[10] != 0 || v[11] != 0))
    return {"a material that is tilted out of the plane would shear across it",
            "leave out angle_x and angle_y but in a solid"};
  return {};
}

/// Columns: the material's axes after rotations about x, y and z by the angles z, y, x.
inline Tensor<3> frame_axes(const double* angles) {
  Tensor<3> frame = identity<3>();
  for (int axis = 0; axis < 3; ++axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const double c = std::cos(angles[2 - axis]), s = std::sin(angles[2 - axis]);
    Tensor<3> turn = identity<3>();
    turn(i, i) = turn(j, j) = c;
    turn(i, j) = -s;
    turn(j, i) = s;
    frame = product(turn, frame);
  }
  return frame;
}

/// What is left of the stiffness where the material's axes beyond the grid's are free of stress.
inline OrthotropicStiffness without_rest(OrthotropicStiffness c, Dimension dimension) {
  for (int r = 2; rest_is_free(dimension) && r >= grid_axes(dimension); --r)
    for (int i = 0; i < r; ++i)
      for (int j = 0; j < r; ++j) c.normal[i][j] -= c.normal[i][r] * c.normal[r][j] / c.normal[r][r];
  return c;
}

/// The largest eigenvalue of the acoustic tensor at rest over normals 5 degrees apart, between which it exceeds
/// them by less than a hundredth.
inline double fastest_wave(const OrthotropicStiffness& stiffness, const Tensor<3>& frame, Dimension dimension) {
  const OrthotropicStiffness c = without_rest(stiffness, dimension);
  const int axes = grid_axes(dimension), turns = axes > 1 ? 36 : 1, rises = axes > 2 ? 36 : 1;
  double fastest = 0;
  for (int t = 0; t < turns; ++t)
    for (int r = 0; r < rises; ++r) {
      const double turn = std::numbers::pi * t / 36, rise = std::numbers::pi * r / 36;
      const double place[] = {std::cos(turn) * std::cos(rise), std::sin(turn) * std::cos(rise), std::sin(rise)};
      double n[3] = {};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) n[i] += frame(j, i) * place[j];
      SymmetricTensor<3> acoustic{};
      for (int i = 0; i < axes; ++i)
        for (int j = 0; j < axes; ++j) {
          const double g = i == j ? 0 : c.shear[SymmetricTensor<3>::place(i, j)];
          acoustic(i, i) += i == j ? c.normal[i][i] * n[i] * n[i] : g * n[j] * n[j];
          if (i < j) acoustic(i, j) = (c.normal[i][j] + g) * n[i] * n[j];
        }
      const std::array<double, 3> speeds = eigenvalues(acoustic);
      fastest = std::max({fastest, speeds[0], speeds[1], speeds[2]});
    }
  return axes > 1 ? 1.01 * fastest : fastest;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
