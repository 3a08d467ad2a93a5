#pragma once

#include <Eigen/SparseCore>

#include "solver/implicit/places.h"

namespace trajan {

/// Each row has the entries of one unknown.
using Interpolation = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The unknowns of a grid whose cells are twice as large, every second node along each axis, that others are
/// interpolated from.
struct Coarsening {
  Places places;
  /// From their values to those on the finer grid, linear along each axis: what is linear in space, rigid motions
  /// among it, is kept.
  Interpolation interpolation;
};
Coarsening coarsen(const Places& fine);

/// Galerkin's matrix on the coarser grid: restriction matrix interpolation, of a symmetric matrix; `restriction`:
/// the transpose of the interpolation.
Eigen::SparseMatrix<double> galerkin(const Eigen::SparseMatrix<double>& matrix, const Interpolation& interpolation,
                                     const Interpolation& restriction);

}  // namespace trajan
