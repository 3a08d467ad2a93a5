#include "solver/model/lattice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trajan {

namespace {

/// Points this close to a rim, in spacings, belong to the disc: more than rounding moves them.
constexpr double rim = 1e-9;

double points_along(double length, double spacing) { return std::max(1.0, std::round(length / spacing)); }

Lattice fill(const Box& box, double spacing, int axes) {
  Lattice lattice;
  lattice.geometry = box;
  const auto along = [spacing](double lower, double upper, std::int64_t& points, double& step, double& first) {
    points = static_cast<std::int64_t>(points_along(upper - lower, spacing));
    step = (upper - lower) / static_cast<double>(points);
    first = lower + step / 2;
  };
  along(box.lower.x, box.upper.x, lattice.columns, lattice.spacing.x, lattice.first.x);
  if (axes > 1) along(box.lower.y, box.upper.y, lattice.rows, lattice.spacing.y, lattice.first.y);
  if (axes > 2) along(box.lower.z, box.upper.z, lattice.planes, lattice.spacing.z, lattice.first.z);
  return lattice;
}

Lattice fill(const Disc& disc, Vector origin, double spacing) {
  const double radius = disc.radius + rim * spacing;
  const auto first = [&](double centre, double from) {
    return std::ceil((centre - radius - from) / spacing - 0.5);
  };
  const auto last = [&](double centre, double from) {
    return std::floor((centre + radius - from) / spacing - 0.5);
  };
  const double i0 = first(disc.centre.x, origin.x), i1 = last(disc.centre.x, origin.x);
  const double j0 = first(disc.centre.y, origin.y), j1 = last(disc.centre.y, origin.y);
  Lattice lattice;
  lattice.columns = static_cast<std::int64_t>(std::max(0.0, i1 - i0 + 1));
  lattice.rows = static_cast<std::int64_t>(std::max(0.0, j1 - j0 + 1));
  lattice.spacing = {spacing, spacing};
  lattice.first = {origin.x + (i0 + 0.5) * spacing, origin.y + (j0 + 0.5) * spacing};
  lattice.geometry = disc;
  return lattice;
}

}  // namespace

Lattice::Range Lattice::columns_in_row(std::int64_t row) const {
  const Disc* disc = std::get_if<Disc>(&geometry);
  if (disc == nullptr) return {0, columns};
  const double radius = disc->radius + rim * spacing.x;
  const double dy = first.y + static_cast<double>(row) * spacing.y - disc->centre.y;
  const double square = radius * radius - dy * dy;
  if (square < 0) return {0, 0};
  const double half = std::sqrt(square);
  const double from = std::ceil((disc->centre.x - half - first.x) / spacing.x);
  const double to = std::floor((disc->centre.x + half - first.x) / spacing.x) + 1;
  const std::int64_t begin = std::clamp<std::int64_t>(static_cast<std::int64_t>(from), 0, columns);
  return {begin, std::clamp<std::int64_t>(static_cast<std::int64_t>(to), begin, columns)};
}

std::int64_t Lattice::count() const {
  if (!std::holds_alternative<Disc>(geometry)) return columns * row_count();
  std::int64_t points = 0;
  for (std::int64_t row = 0; row < row_count(); ++row) {
    const Range range = columns_in_row(row);
    points += range.end - range.begin;
  }
  return points;
}

Vector Lattice::point_of(std::int64_t number) const {
  std::int64_t row = 0;
  Range range = columns_in_row(row);
  for (; number >= range.end - range.begin; range = columns_in_row(++row)) number -= range.end - range.begin;
  return point(range.begin + number, row);
}

Lattice make_lattice(const Region& geometry, Vector grid_origin, double cell, int particles_per_cell_side,
                     int axes) {
  const double spacing = cell / particles_per_cell_side;
  if (const Box* box = std::get_if<Box>(&geometry)) return fill(*box, spacing, axes);
  return fill(std::get<Disc>(geometry), grid_origin, spacing);
}

double estimated_points(const Region& geometry, double cell, int particles_per_cell_side, int axes) {
  const double spacing = cell / particles_per_cell_side;
  if (const Box* box = std::get_if<Box>(&geometry)) {
    double points = points_along(box->upper.x - box->lower.x, spacing);
    if (axes > 1) points *= points_along(box->upper.y - box->lower.y, spacing);
    if (axes > 2) points *= points_along(box->upper.z - box->lower.z, spacing);
    return points;
  }
  const double radius = std::get<Disc>(geometry).radius / spacing;
  return std::numbers::pi * radius * radius;
}

}  // namespace trajan
