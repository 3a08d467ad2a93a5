#pragma once

#include <cstdint>

#include "solver/scene/scene.h"

namespace trajan {

/// The reference positions of a body's particles: the points first + (i, j, k) * spacing, 0 <= i < columns,
/// 0 <= j < rows, 0 <= k < planes, that lie in the geometry. A box holds all of them. Counting and numbering
/// go row by row and plane by plane and need no memory. Rows are counted over all planes: row j of plane k is
/// number k * rows + j. Along an axis that the dimension does not have there is one point, at 0.
class Lattice {
 public:
  Vector first;
  Vector spacing;
  std::int64_t columns = 0;
  std::int64_t rows = 1;
  std::int64_t planes = 1;
  Region geometry;

  std::int64_t row_count() const { return rows * planes; }

  /// Half-open range of columns that lie in the geometry in this row.
  struct Range {
    std::int64_t begin = 0;
    std::int64_t end = 0;
  };
  Range columns_in_row(std::int64_t row) const;
  Vector point(std::int64_t column, std::int64_t row) const {
    return {first.x + static_cast<double>(column) * spacing.x,
            first.y + static_cast<double>(row % rows) * spacing.y,
            first.z + static_cast<double>(row / rows) * spacing.z};
  }
  /// Calls visit(number from 0 on, point) for all points in order.
  template <class Visit>
  void for_each_point(Visit&& visit) const;
  /// The point of this number.
  Vector point_of(std::int64_t number) const;
  /// Number of points. A box takes no time, a disc time with its rows.
  std::int64_t count() const;
};

/// A box is filled with a lattice that fits its sides exactly (the nearest whole number of particles to
/// the asked spacing), a disc with the sub-cell lattice of the grid. Precondition: the geometry is given,
/// and estimated_points is below 2^60.
Lattice make_lattice(const Region& geometry, Vector grid_origin, double cell, int particles_per_cell_side,
                     int axes);

/// About the number of points that make_lattice would give, from arithmetic alone; infinite or not a
/// number for geometries that are not finite.
double estimated_points(const Region& geometry, double cell, int particles_per_cell_side, int axes);

template <class Visit>
void Lattice::for_each_point(Visit&& visit) const {
  std::int64_t number = 0;
  for (std::int64_t row = 0; row < row_count(); ++row) {
    const Range range = columns_in_row(row);
    for (std::int64_t column = range.begin; column < range.end; ++column) visit(number++, point(column, row));
  }
}

}  // namespace trajan
