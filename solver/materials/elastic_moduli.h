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

  LameConstants(double youngs_modulus, double poissons_ratio)
      : lambda(youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio))),
        mu(youngs_modulus / (2 * (1 + poissons_ratio))) {}

  /// lambda, or in plane stress what is left of it once the out-of-plane strain has removed the
  /// out-of-plane stress: 2 lambda mu / (lambda + 2 mu).
  double in_plane_lambda(Dimension dimension) const {
    return dimension == Dimension::plane_stress ? 2 * lambda * mu / (lambda + 2 * mu) : lambda;
  }

  /// Modulus of the plane longitudinal wave, the fastest one: rho c^2.
  double wave_modulus(Dimension dimension) const { return in_plane_lambda(dimension) + 2 * mu; }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
