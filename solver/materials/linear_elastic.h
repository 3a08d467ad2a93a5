#pragma once

#include <cmath>

#include "solver/materials/elastic_moduli.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Isotropic linear elasticity in rate form with the Jaumann rate of the Cauchy stress.
class LinearElastic {
 public:
  static constexpr std::string_view name = "linear_elastic";
  static constexpr std::string_view source = "Jaumann rate of Cauchy stress; Asiri 2022, eq. 2.16";
  static constexpr Parameter parameters[] = {youngs_modulus_parameter, poissons_ratio_parameter};

  static double wave_speed(std::span<const double> values, double density, Dimension dimension) {
    return std::sqrt(LameConstants(values[0], values[1]).wave_modulus(dimension) / density);
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
