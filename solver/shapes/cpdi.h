#pragma once

#include <string_view>

#include "solver/executors/instruction_set.h"
#include "solver/executors/layout.h"
#include "solver/shapes/whole_part.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Convected particle domains: parallelepipeds that deform with their particle, piecewise linear functions
/// interpolated between their corners (Sadeghirad, Brannon and Burghardt 2011).
struct Cpdi {
  static constexpr std::string_view name = "cpdi";
  /// Weights are no products along the axes, but means over the corners of the particle's domain.
  static constexpr bool corners = true;
  static constexpr int nodes = 4;
  static constexpr Reach reach = Reach::wide;
  static constexpr bool needs_deformation = true;

  template <class Place>
  static constexpr Place first_node(Place at) {
    return whole_part(at) - 1;
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
