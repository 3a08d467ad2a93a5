#pragma once

#include <string_view>

#include "solver/executors/instruction_set.h"
#include "solver/executors/layout.h"
#include "solver/shapes/whole_part.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Piecewise linear functions (Sulsky, Chen and Schreyer 1994).
struct Linear {
  static constexpr std::string_view name = "linear";
  static constexpr int nodes = 2;
  static constexpr Reach reach = Reach::cell;
  static constexpr bool folds = false;
  static constexpr bool needs_deformation = false;

  template <class Place>
  static constexpr Place first_node(Place at) {
    return whole_part(at);
  }
  static void weigh(Real p, Real, Real (&weight)[2], Real (&slope)[2]) {
    weight[0] = 1 - p;
    weight[1] = p;
    slope[0] = -1;
    slope[1] = 1;
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
