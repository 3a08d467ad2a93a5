#include "solver/model/lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "solver/model/geometry.h"

namespace trajan {

namespace {

/// Points this close to a boundary, in spacings, belong to the geometry: more than rounding moves them.
constexpr double rim = 1e-9;

/// So many rows have their first number kept, to find a number without counting all rows before it.
constexpr std::int64_t most_starts = 4096;

double points_along(double length, double spacing) { return std::max(1.0, std::round(length / spacing)); }

/// Indices of the first and the last point between two coordinates.
struct Indices {
  double first, last;
  double count() const { return std::max(0.0, last - first + 1); }
};

Indices indices(double lower, double upper, double origin, double spacing) {
  return {std::ceil((lower - origin) / spacing - 0.5 - rim), std::floor((upper - origin) / spacing - 0.5 + rim)};
}

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

Lattice fill(const Region& region, Vector origin, double spacing, int axes) {
  Lattice lattice;
  lattice.geometry = region;
  const Box box = bounds(region);
  const auto along = [spacing](double lower, double upper, double from, std::int64_t& points, double& step,
                               double& first) {
    const Indices found = indices(lower, upper, from, spacing);
    points = static_cast<std::int64_t>(found.count());
    step = spacing;
    first = from + (found.first + 0.5) * spacing;
  };
  along(box.lower.x, box.upper.x, origin.x, lattice.columns, lattice.spacing.x, lattice.first.x);
  if (axes > 1) along(box.lower.y, box.upper.y, origin.y, lattice.rows, lattice.spacing.y, lattice.first.y);
  if (axes > 2) along(box.lower.z, box.upper.z, origin.z, lattice.planes, lattice.spacing.z, lattice.first.z);
  return lattice;
}

/// Gauss and Legendre's points between -1 and 1, ascending, and their weights (Abramowitz and Stegun
/// 1964, 25.4.29), by Newton's method from their asymptotic places.
std::vector<std::array<double, 2>> gauss_rule(int n) {
  std::vector<std::array<double, 2>> rule;
  for (int i = n; i > 0; --i) {
    double x = std::cos(std::numbers::pi * (i - 0.25) / (n + 0.5)), slope = 1;
    for (int round = 0; round < 10; ++round) {
      double before = 1, value = x;
      for (int k = 2; k <= n; ++k) before = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * before) / k);
      slope = n * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    rule.push_back({x, 2 / ((1 - x * x) * slope * slope)});
  }
  return rule;
}

}  // namespace

Lattice::Ranges Lattice::columns_in_row(std::int64_t row) const {
  if (full()) return {{0, columns}};
  const Vector start = point(0, row);
  const double most = static_cast<double>(columns);
  Ranges ranges;
  for (const Span& span : spans(geometry, start.y, start.z, rim * spacing.x)) {
    const double from = std::ceil((span.from - start.x) / spacing.x);
    const double to = std::floor((span.to - start.x) / spacing.x) + 1;
    const double taken = ranges.empty() ? 0 : static_cast<double>(ranges.back().end);
    const double begin = std::clamp(from, taken, most), end = std::clamp(to, begin, most);
    if (begin < end) ranges.push_back({static_cast<std::int64_t>(begin), static_cast<std::int64_t>(end)});
  }
  return ranges;
}

void Lattice::number_points() {
  if (full()) {
    count_ = columns * row_count();
    return;
  }
  count_ = 0;
  stride_ = row_count() / most_starts + 1;
  starts_.clear();
  for (std::int64_t row = 0; row < row_count(); ++row) {
    if (row % stride_ == 0) starts_.push_back(count_);
    for (const Range& range : columns_in_row(row)) count_ += range.end - range.begin;
  }
}

void Lattice::place_at_gauss_points(int particles_per_cell_side) {
  const double n = particles_per_cell_side;
  for (const auto& [place, weight] : gauss_rule(particles_per_cell_side)) {
    offsets.push_back(0.5 * (1 + place) * n - 0.5 - static_cast<double>(offsets.size()));
    shares.push_back(0.5 * weight * n);
  }
}

double Lattice::share(std::int64_t number, int axes) const {
  if (shares.empty()) return 1;
  const auto of = [this](std::int64_t i) { return shares[static_cast<std::size_t>(i) % shares.size()]; };
  const std::int64_t row = number / columns;
  return of(number % columns) * (axes > 1 ? of(row % rows) : 1.0) * (axes > 2 ? of(row / rows) : 1.0);
}

Vector Lattice::point_of(std::int64_t number) const {
  if (full()) return point(number % columns, number / columns);
  // The last start that is not after the number; rows without points share their start with the next.
  const auto after = std::ranges::upper_bound(starts_, number);
  const std::int64_t known = std::distance(starts_.begin(), after) - 1;
  std::int64_t before = starts_[static_cast<std::size_t>(known)];
  for (std::int64_t row = known * stride_;; ++row) {
    for (const Range& range : columns_in_row(row)) {
      const std::int64_t points = range.end - range.begin;
      if (number - before < points) return point(range.begin + number - before, row);
      before += points;
    }
  }
}

Lattice make_lattice(const Region& geometry, Vector grid_origin, double cell, int particles_per_cell_side,
                     int axes) {
  const double spacing = cell / particles_per_cell_side;
  if (const Box* box = std::get_if<Box>(&geometry)) return fill(*box, spacing, axes);
  return fill(geometry, grid_origin, spacing, axes);
}

LatticeSize lattice_size(const Region& geometry, double cell, int particles_per_cell_side, int axes) {
  const double spacing = cell / particles_per_cell_side;
  const Box box = bounds(geometry);
  const bool full = std::holds_alternative<Box>(geometry);
  const auto along = [&](double lower, double upper) {
    return full ? points_along(upper - lower, spacing) : std::max(0.0, (upper - lower) / spacing + 1);
  };
  double rows = 1;
  if (axes > 1) rows *= along(box.lower.y, box.upper.y);
  if (axes > 2) rows *= along(box.lower.z, box.upper.z);
  return {rows * along(box.lower.x, box.upper.x), full ? 1 : rows * work_of_a_line(geometry)};
}

}  // namespace trajan
