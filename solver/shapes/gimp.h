#pragma once

#include <string_view>

#include "solver/shapes/particle_domain.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Generalized interpolation, uniform: particle domains keep their size (Bardenhagen and Kober 2004).
struct Gimp {
  static constexpr std::string_view name = "gimp";
  static constexpr int nodes = 3;
  static constexpr bool wide = true;
  static constexpr bool folds = true;
  static constexpr bool needs_deformation = false;

  static constexpr int first_node(double at) { return static_cast<int>(at - 0.5); }
  static void weigh(Real p, Real half_size, Real (&weight)[3], Real (&slope)[3]) {
    average_hats(p, half_size < Real(0.5) ? half_size : Real(0.5), weight, slope);
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
