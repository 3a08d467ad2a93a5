#pragma once

#include <cmath>

#include "solver/materials/elastic_moduli.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Compressible neo-Hookean solid.
class NeoHookean {
 public:
  static constexpr std::string_view name = "neo_hookean";
  static constexpr std::string_view source = "P = mu (F - F^-T) + lambda ln(J) F^-T; Asiri 2022, eq. 2.17";
  static constexpr Parameter parameters[] = {youngs_modulus_parameter, poissons_ratio_parameter};

  static double wave_speed(std::span<const double> values, double density, Dimension dimension) {
    return std::sqrt(LameConstants(values[0], values[1]).wave_modulus(dimension) / density);
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
