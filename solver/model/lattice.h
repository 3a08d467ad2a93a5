#pragma once

#include <cstdint>

#include "solver/scene/scene.h"

namespace trajan {

/// The reference positions of a body's particles: the points first + (i * spacing.x, j * spacing.y),
/// 0 <= i < columns, 0 <= j < rows, that lie in the geometry. A box holds all of them. Counting and
/// numbering go row by row and need no memory.
class Lattice {
 public:
  Vector first;
  Vector spacing;
  std::int64_t columns = 0;
  std::int64_t rows = 0;
  Region geometry;

  /// Half-open range of columns that lie in the geometry in this row.
  struct Range {
    std::int64_t begin = 0;
    std::int64_t end = 0;
  };
  Range columns_in_row(std::int64_t row) const;
  Vector point(std::int64_t column, std::int64_t row) const {
    return {first.x + static_cast<double>(column) * spacing.x, first.y + static_cast<double>(row) * spacing.y};
  }
  /// Number of points. A box takes no time, a disc time with its rows.
  std::int64_t count() const;
};

/// A box is filled with a lattice that fits its sides exactly (the nearest whole number of particles to
/// the asked spacing), a disc with the sub-cell lattice of the grid. Precondition: the geometry is given,
/// and estimated_points is below 2^60.
Lattice make_lattice(const Region& geometry, Vector grid_origin, double cell, int particles_per_cell_side);

/// About the number of points that make_lattice would give, from arithmetic alone; infinite or not a
/// number for geometries that are not finite.
double estimated_points(const Region& geometry, double cell, int particles_per_cell_side);

}  // namespace trajan
