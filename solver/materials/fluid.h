#pragma once

#include "solver/materials/law.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Why a fluid must not be used in this dimension, or empty.
inline std::string_view objection_to_fluid(Dimension dimension) {
  if (dimension != Dimension::plane_stress && dimension != Dimension::bar) return "";
  return "a fluid resists no change of shape: it would thin without end where the stress is zero across; "
         "use plane strain, axisymmetry or a solid";
}

/// Moduli of waves in a fluid: rho c^2, and no shear.
inline LameConstants fluid_moduli(double wave_modulus) { return {wave_modulus, 0}; }

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
