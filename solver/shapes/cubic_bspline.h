#pragma once

#include <string_view>

#include "solver/executors/instruction_set.h"
#include "solver/executors/layout.h"
#include "solver/shapes/whole_part.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Cubic B-splines centred on the nodes (Steffen, Kirby and Berzins 2008).
struct CubicBspline {
  static constexpr std::string_view name = "cubic_bspline";
  static constexpr int nodes = 4;
  static constexpr Reach reach = Reach::wide;
  static constexpr bool folds = true;
  static constexpr bool needs_deformation = false;
  /// sum w_I (x_I - x_p)^2 away from faces, in squared cells (Jiang et al. 2015).
  static constexpr Real inertia = Real(1) / 3;

  template <class Place>
  static constexpr Place first_node(Place at) {
    return whole_part(at) - 1;
  }
  /// p is between 1 and 2.
  static void weigh(Real p, Real, Real (&weight)[4], Real (&slope)[4]) {
    const Real f = p - 1, g = 2 - p;
    weight[0] = g * g * g / 6;
    weight[1] = (4 + f * f * (3 * f - 6)) / 6;
    weight[2] = (4 + g * g * (3 * g - 6)) / 6;
    weight[3] = f * f * f / 6;
    slope[0] = -g * g / 2;
    slope[1] = f * (Real(1.5) * f - 2);
    slope[2] = g * (2 - Real(1.5) * g);
    slope[3] = f * f / 2;
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
