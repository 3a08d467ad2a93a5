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

/// nullptr: there are no shape functions of that name.
StencilKernel stencil_kernel(std::string_view shape_functions, Dimension dimension);

/// The degree of the polynomials that these shape functions' sums on the grid reproduce.
int polynomial_degree(std::string_view shape_functions);

}  // namespace trajan
