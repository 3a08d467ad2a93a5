#pragma once

#include <string_view>

#include "solver/executors/layout.h"
#include "solver/shapes/particle_domain.h"
#include "solver/shapes/whole_part.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Generalized interpolation, uniform: particle domains keep their size (Bardenhagen and Kober 2004).
struct Gimp {
  static constexpr std::string_view name = "gimp";
  static constexpr int nodes = 3;
  static constexpr Reach reach = Reach::staggered;
  static constexpr bool folds = true;
  static constexpr bool needs_deformation = false;

  template <class Place>
  static constexpr Place first_node(Place at) {
    return whole_part(at - begin_of_cells(reach));
  }
  /// p is between 1/2 and 3/2: only the middle node may be within the domain.
  static void weigh(Real p, Real half_size, Real (&weight)[3], Real (&slope)[3]) {
    const Real bounded = half_size < Real(0.5) ? half_size : Real(0.5), factor = Real(0.5) / bounded;
    const AveragedHat first = average_outer_hat(p, bounded, factor),
                      last = average_outer_hat(2 - p, bounded, factor);
    weight[0] = first.weight;
    weight[1] = 1 - (first.weight + last.weight);
    weight[2] = last.weight;
    slope[0] = first.slope;
    slope[1] = last.slope - first.slope;
    slope[2] = -last.slope;
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
