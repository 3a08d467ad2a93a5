#pragma once

#include <string_view>

#include "solver/executors/layout.h"
#include "solver/shapes/particle_domain.h"
#include "solver/shapes/whole_part.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Generalized interpolation with contiguous particles: domains stay along the axes and are stretched by the
/// diagonal of the deformation gradient (Bardenhagen and Kober 2004). Rotation shrinks them: "cpdi" turns them.
struct Cpgimp {
  static constexpr std::string_view name = "cpgimp";
  static constexpr int nodes = 4;
  static constexpr Reach reach = Reach::wide;
  static constexpr bool folds = true;
  static constexpr bool needs_deformation = true;

  template <class Place>
  static constexpr Place first_node(Place at) {
    return whole_part(at) - 1;
  }
  /// Domains wider than two cells are taken as two cells wide, hardly any width as a fiftieth.
  /// p is between 1 and 2: the outer nodes are not within the domain.
  static void weigh(Real p, Real half_size, Real (&weight)[4], Real (&slope)[4]) {
    const Real size = half_size < 0 ? -half_size : half_size;
    const Real bounded = size < Real(0.01) ? Real(0.01) : size > 1 ? 1 : size;
    const Real factor = Real(0.5) / bounded;
    const AveragedHat first = average_outer_hat(p, bounded, factor), second = average_hat(p - 1, bounded, factor),
                      last = average_outer_hat(3 - p, bounded, factor);
    weight[0] = first.weight;
    weight[1] = second.weight;
    weight[2] = 1 - (first.weight + second.weight + last.weight);
    weight[3] = last.weight;
    slope[0] = first.slope;
    slope[1] = second.slope;
    slope[2] = last.slope - (first.slope + second.slope);
    slope[3] = -last.slope;
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
