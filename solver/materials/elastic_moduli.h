#pragma once

#include "solver/executors/instruction_set.h"
#include "solver/materials/material.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The table of isotropic elasticity: what the first two parameters of every isotropic law mean.
inline constexpr Parameter youngs_modulus_parameter{"youngs_modulus", "stress", "Young's modulus at small strain",
                                                    0.0, 1e300};
inline constexpr Parameter poissons_ratio_parameter{"poissons_ratio", "1", "Poisson's ratio at small strain", -1.0,
                                                    0.5};

/// Lame constants of isotropic elasticity, stress units.
struct LameConstants {
  double lambda;
  double mu;

  static LameConstants of(double youngs_modulus, double poissons_ratio) {
    return {youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)),
            youngs_modulus / (2 * (1 + poissons_ratio))};
  }
  double bulk_modulus() const { return lambda + 2 * mu / 3; }
  double poissons_ratio() const { return lambda / (2 * (lambda + mu)); }
  double youngs_modulus() const { return 2 * mu * (1 + poissons_ratio()); }

  /// Strain along each axis of the rest that frees it of stress, per dilation of the grid's axes.
  double thinning(Dimension dimension) const {
    if (dimension == Dimension::plane_stress) return -lambda / (lambda + 2 * mu);
    return dimension == Dimension::bar ? -poissons_ratio() : 0.0;
  }

  /// Modulus of the longitudinal wave, the fastest one: rho c^2.
  double wave_modulus(Dimension dimension) const {
    const double rest_axes = dimension == Dimension::bar ? 2 : 1;
    return lambda * (1 + rest_axes * thinning(dimension)) + 2 * mu;
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
