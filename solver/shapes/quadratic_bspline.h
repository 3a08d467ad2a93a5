#pragma once

#include <string_view>

#include "solver/executors/instruction_set.h"
#include "solver/executors/layout.h"
#include "solver/shapes/whole_part.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Quadratic B-splines centred on the nodes (Steffen, Kirby and Berzins 2008).
struct QuadraticBspline {
  static constexpr std::string_view name = "quadratic_bspline";
  static constexpr int nodes = 3;
  static constexpr Reach reach = Reach::staggered;
  static constexpr bool folds = true;
  static constexpr bool needs_deformation = false;
  /// sum w_I (x_I - x_p)^2 away from faces, in squared cells (Jiang et al. 2015).
  static constexpr Real inertia = Real(1) / 4;

  template <class Place>
  static constexpr Place first_node(Place at) {
    return whole_part(at - begin_of_cells(reach));
  }
  /// p is between 1/2 and 3/2.
  static void weigh(Real p, Real, Real (&weight)[3], Real (&slope)[3]) {
    const Real below = Real(1.5) - p, middle = p - 1, above = p - Real(0.5);
    weight[0] = below * below / 2;
    weight[1] = Real(0.75) - middle * middle;
    weight[2] = above * above / 2;
    slope[0] = -below;
    slope[1] = -2 * middle;
    slope[2] = above;
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
