#pragma once

#include <cstdint>
#include <vector>

#include "solver/scene/scene.h"

namespace trajan {

/// The reference positions of a body's particles: the points first + (i, j, k) * spacing, 0 <= i < columns,
/// 0 <= j < rows, 0 <= k < planes, that lie in the geometry, or points near them. A box holds all of them.
/// Numbering goes row by row and plane by plane. Rows are counted over all planes: row j of plane k is number k *
/// rows + j. Along an axis that the dimension does not have there is one point, at 0.
class Lattice {
 public:
  Vector first;
  Vector spacing;
  std::int64_t columns = 0;
  std::int64_t rows = 1;
  std::int64_t planes = 1;
  Region geometry;
  /// Along each axis, of the points of a cell: how far they lie off the even places, in spacings, and their shares
  /// of the volume, which are 1 on average. Empty: points are even.
  std::vector<double> offsets, shares;
  /// More spacings than any point lies off its even place, 0 of even points.
  std::int64_t unevenness() const { return offsets.empty() ? 0 : 2; }
  /// Moves the points of a box whose sides lie between cells to those of Gauss and Legendre's rule in each cell.
  void place_at_gauss_points(int particles_per_cell_side);

  /// Half-open range of columns.
  struct Range {
    std::int64_t begin = 0;
    std::int64_t end = 0;
  };
  using Ranges = std::vector<Range>;
  /// The columns of a row that lie in the geometry, in order and apart from each other.
  Ranges columns_in_row(std::int64_t row) const;
  std::int64_t row_count() const { return rows * planes; }
  Vector point(std::int64_t column, std::int64_t row) const {
    return {first.x + even(column) * spacing.x, first.y + even(row % rows) * spacing.y,
            first.z + even(row / rows) * spacing.z};
  }
  /// A point's place along an axis, in spacings from the first even one.
  double even(std::int64_t i) const {
    return static_cast<double>(i) +
           (offsets.empty() ? 0.0 : offsets[static_cast<std::size_t>(i) % offsets.size()]);
  }
  /// The volume of the particle of this number, over the mean.
  double share(std::int64_t number, int axes) const;
  /// Number of points.
  std::int64_t count() const { return count_; }
  /// Calls visit(number from 0 on, point) for all points in order.
  template <class Visit>
  void for_each_point(Visit&& visit) const;
  /// Calls visit(row, range of columns, number of the first of them) for begin <= row < end.
  template <class Visit>
  void for_each_range(std::int64_t begin, std::int64_t end, Visit&& visit) const;
  /// The point of this number.
  Vector point_of(std::int64_t number) const;

  /// Counts the points; takes time with `counting_work`.
  void number_points();

 private:
  bool full() const { return std::holds_alternative<Box>(geometry); }

  std::int64_t count_ = 0;
  std::int64_t stride_ = 1;           ///< rows
  std::vector<std::int64_t> starts_;  ///< number of the first point of every stride_-th row; empty: all lie in it
};

/// Where the lattice of a geometry is: a box is filled with one that fits its sides exactly (the nearest whole
/// number of particles to the asked spacing), any other region with the sub-cell lattice of the grid. Its points
/// are still to be numbered. Precondition: the geometry is right, and lattice_size is below 2^60.
Lattice make_lattice(const Region& geometry, Vector grid_origin, double cell, int particles_per_cell_side,
                     int axes);

/// How large a lattice would be, from arithmetic alone; infinite or not a number for extreme geometries.
struct LatticeSize {
  double points = 0;  ///< in the geometry if it is a box, otherwise in the box around it
  double work = 0;    ///< of counting the points: numbers to be looked at
};
LatticeSize lattice_size(const Region& geometry, double cell, int particles_per_cell_side, int axes);

template <class Visit>
void Lattice::for_each_range(std::int64_t begin, std::int64_t end, Visit&& visit) const {
  if (full()) {
    for (std::int64_t row = begin; row < end; ++row) visit(row, Range{0, columns}, row * columns);
    return;
  }
  const std::int64_t known = begin / stride_;
  std::int64_t number = begin < end ? starts_[static_cast<std::size_t>(known)] : 0;
  for (std::int64_t row = known * stride_; row < end; ++row) {
    for (const Range& range : columns_in_row(row)) {
      if (row >= begin) visit(row, range, number);
      number += range.end - range.begin;
    }
  }
}

template <class Visit>
void Lattice::for_each_point(Visit&& visit) const {
  for_each_range(0, row_count(), [&](std::int64_t row, Range range, std::int64_t number) {
    for (std::int64_t column = range.begin; column < range.end; ++column) visit(number++, point(column, row));
  });
}

}  // namespace trajan
