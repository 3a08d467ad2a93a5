#pragma once

#include <string_view>

#include "solver/shapes/particle_domain.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Generalized interpolation with contiguous particles: domains stay along the axes and are stretched by the
/// diagonal of the deformation gradient (Bardenhagen and Kober 2004). Rotation shrinks them: "cpdi" turns them.
struct Cpgimp {
  static constexpr std::string_view name = "cpgimp";
  static constexpr int nodes = 4;
  static constexpr bool wide = true;
  static constexpr bool folds = true;
  static constexpr bool needs_deformation = true;

  static constexpr int first_node(double at) { return static_cast<int>(at) - 1; }
  /// Domains wider than two cells are taken as two cells wide, hardly any width as a fiftieth.
  static void weigh(Real p, Real half_size, Real (&weight)[4], Real (&slope)[4]) {
    const Real size = half_size < 0 ? -half_size : half_size;
    const Real bounded = size < Real(0.01) ? Real(0.01) : size > 1 ? 1 : size;
    average_hats(p, bounded, weight, slope);
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
