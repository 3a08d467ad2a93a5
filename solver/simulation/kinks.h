#pragma once

#include "solver/model/model.h"
#include "solver/schemes/scheme.h"

namespace trajan {

/// Whether particles keep the slopes that their shape functions have at faces of cells, where these have kinks.
inline bool has_kinks_at_rest(const Model& model) {
  const std::string& functions = model.numerics.shape_functions;
  return is_total_lagrangian(model.numerics.scheme) && (functions == "linear" || functions == "bernstein");
}

}  // namespace trajan
