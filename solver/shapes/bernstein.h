#pragma once

#include <string_view>

#include "solver/executors/instruction_set.h"
#include "solver/executors/layout.h"
#include "solver/shapes/whole_part.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Quadratic Bernstein polynomials (de Vaucorbeil, Nguyen and Hutchinson 2020) on elements of two cells along
/// each axis, so that control points lie on the nodes of the grid.
struct Bernstein {
  static constexpr std::string_view name = "bernstein";
  static constexpr int nodes = 3;
  static constexpr Reach reach = Reach::wide;
  static constexpr bool folds = false;
  static constexpr bool needs_deformation = false;
  /// An element's first node is even. So are those of tiles, and windows with a margin begin two nodes before.
  static constexpr bool needs_margin = true;

  template <class Place>
  static constexpr Place first_node(Place at) {
    return twice(whole_part(half(at)));
  }
  static void weigh(Real p, Real, Real (&weight)[3], Real (&slope)[3]) {
    const Real s = p / 2, r = 1 - s;
    weight[0] = r * r;
    weight[1] = 2 * r * s;
    weight[2] = s * s;
    slope[0] = -r;
    slope[1] = r - s;
    slope[2] = s;
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
