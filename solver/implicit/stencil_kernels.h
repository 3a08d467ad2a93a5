#pragma once

#include <string_view>
#include <vector>

#include "solver/executors/block.h"
#include "solver/scene/scene.h"

namespace trajan {

/// The shape functions of particles, one particle after the other: for each of its nodes the weight and as many
/// components of the weight's gradient as the grid has axes. Nodes without weight and gradient are left out.
struct BlockStencils {
  std::vector<int> counts;  ///< by particle
  std::vector<int> nodes;   ///< of the block's window
  std::vector<double> weights;
  std::vector<double> gradients;  ///< per length

  void clear() { counts.clear(), nodes.clear(), weights.clear(), gradients.clear(); }
};

/// Appends those of a block. What particles are out of their window is counted as trouble.
using StencilKernel = void (*)(Block&, BlockStencils&);

/// nullptr: there are no shape functions of that name. `to_faces`: splines keep their degree up to faces of the
/// domain (solver/surfaces/spline_faces.h).
StencilKernel stencil_kernel(std::string_view shape_functions, Dimension dimension, bool to_faces);

/// The degree of the polynomials that these shape functions' sums on the grid reproduce.
constexpr int polynomial_degree(std::string_view shape_functions) {
  return shape_functions == "cubic_bspline"                                         ? 3
         : shape_functions == "quadratic_bspline" || shape_functions == "bernstein" ? 2
                                                                                    : 1;
}

}  // namespace trajan
