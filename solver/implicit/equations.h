#pragma once

#include "solver/model/model.h"

namespace trajan {

/// Work of a Cholesky factor from which on multigrid is faster: of a cube of 13 cells along each side, of a square
/// of 260.
inline constexpr double most_factor_work = 1e8;
/// Entries of a row, on average, of functions for which that is so. There are 81 of linear ones in space; beside
/// faces of bodies wide ones hardly differ from each other, and take ten times as many cycles.
inline constexpr double most_row_entries = 100;

/// To which factorizing a tangent is proportional (nested dissection, George 1973): unknowns times those of a
/// layer across the longest axis, in space times another square root of these. `nodes` is their number along that
/// axis.
double factor_work(double unknowns, double nodes, int axes);

/// The same of all bodies of a model, before there are matrices.
double factor_work(const Model& model);
/// Nodes that a particle sees along an axis.
double nodes_in_reach(const Model& model);
/// Entries of a row inside a body.
double row_entries(const Model& model);
/// Whether SparseSolver is expected to take multigrid for its tangents.
bool takes_multigrid(const Model& model);

}  // namespace trajan
