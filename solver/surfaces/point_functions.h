#pragma once

#include <string_view>

namespace trajan {

/// Nodes along an axis that functions see, at most.
inline constexpr std::size_t most_nodes_along = 4;

/// What shape functions are at a place of a surface, along one axis and in cells.
struct PointFunctions {
  int nodes;                     ///< along an axis
  double lowest, highest;        ///< from the first node: where one polynomial holds
  bool folds;                    ///< beyond a face of the domain there are no functions
  bool averaged;                 ///< particles see means over their domains, which end at the surface
  double (*first_node)(double);  ///< of a place in a window, counted from the window's first node
  void (*weigh)(double place, double* weight, double* slope);  ///< at a place from the first node
};

/// Functions that are means over a particle's domain are those that they are means of: a point has no size.
const PointFunctions& point_functions(std::string_view shape_functions);

/// Takes the functions of the first `below` and the last `above` nodes away, which lie beyond faces of the domain:
/// what they would carry is extrapolated from the two nodes before them (Steffen, Kirby and Berzins 2008).
void fold(const PointFunctions& functions, int below, int above, double* values);

}  // namespace trajan
