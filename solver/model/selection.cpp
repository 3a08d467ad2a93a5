#include "solver/model/selection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trajan {

namespace {

/// In spacings: more than rounding moves a particle, far less than particles are apart.
constexpr double tolerance = 1e-9;

struct Interval {
  double lowest = 0;
  double highest = 0;
};

Interval rows_of(const Region& region) {
  if (const Box* box = std::get_if<Box>(&region)) return {box->lower.y, box->upper.y};
  const Disc& disc = std::get<Disc>(region);
  return {disc.centre.y - disc.radius, disc.centre.y + disc.radius};
}

Interval columns_of(const Region& region) {
  if (const Box* box = std::get_if<Box>(&region)) return {box->lower.x, box->upper.x};
  const Disc& disc = std::get<Disc>(region);
  return {disc.centre.x - disc.radius, disc.centre.x + disc.radius};
}

/// The region's extent in x at this height.
Interval chord(const Region& region, double y, double slack) {
  const Disc* disc = std::get_if<Disc>(&region);
  if (disc == nullptr) return columns_of(region);
  const double radius = disc->radius + slack;
  const double dy = y - disc->centre.y;
  const double half = std::sqrt(std::max(0.0, radius * radius - dy * dy));
  return {disc->centre.x - half, disc->centre.x + half};
}

/// Indices i of the points first + i * spacing in the interval, half-open and clipped to 0..count.
Lattice::Range indices_in(Interval interval, double first, double spacing, std::int64_t count) {
  const double most = static_cast<double>(count);
  const double from = std::ceil((interval.lowest - first) / spacing - tolerance);
  const double to = std::floor((interval.highest - first) / spacing + tolerance) + 1;
  const double begin = std::clamp(from, 0.0, most);
  return {static_cast<std::int64_t>(begin), static_cast<std::int64_t>(std::clamp(to, begin, most))};
}

Lattice::Range rows_in(const Lattice& lattice, const Region& region) {
  return indices_in(rows_of(region), lattice.first.y, lattice.spacing.y, lattice.rows);
}

/// Calls visit(row, columns, number of the first of these columns) for some rows; a disc needs a walk
/// through the rows before them to know the numbers.
template <typename Visit>
void visit_rows(const Body& body, Lattice::Range rows, Visit visit) {
  const Lattice& lattice = body.lattice;
  const bool box = !std::holds_alternative<Disc>(lattice.geometry);
  std::int64_t number = body.first_particle + (box ? rows.begin * lattice.columns : 0);
  for (std::int64_t row = box ? rows.begin : 0; row < rows.end; ++row) {
    const Lattice::Range columns = lattice.columns_in_row(row);
    if (row >= rows.begin) visit(row, columns, number);
    number += columns.end - columns.begin;
  }
}

double distance(Vector a, Vector b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// The two indices next to a coordinate, within the range.
Lattice::Range neighbours(double coordinate, double first, double spacing, Lattice::Range range) {
  const double below = std::floor((coordinate - first) / spacing);
  const auto clamped = [&](double index) {
    return static_cast<std::int64_t>(
        std::clamp(index, static_cast<double>(range.begin), static_cast<double>(range.end - 1)));
  };
  return {clamped(below), clamped(below + 1) + 1};
}

}  // namespace

std::int64_t box_particle(const Body& body, std::int64_t column, std::int64_t row) {
  return body.first_particle + row * body.lattice.columns + column;
}

NearestParticle nearest_particle(const Body& body, Vector place) {
  const Lattice& lattice = body.lattice;
  const Lattice::Range all = {0, lattice.rows};
  const bool box = !std::holds_alternative<Disc>(lattice.geometry);
  const Lattice::Range rows = box ? neighbours(place.y, lattice.first.y, lattice.spacing.y, all) : all;
  const double equal = tolerance * std::min(lattice.spacing.x, lattice.spacing.y);
  NearestParticle best{body.first_particle, std::numeric_limits<double>::infinity()};
  visit_rows(body, rows, [&](std::int64_t row, Lattice::Range columns, std::int64_t number) {
    if (columns.begin == columns.end) return;
    const auto near = neighbours(place.x, lattice.first.x, lattice.spacing.x, columns);
    for (std::int64_t column = near.begin; column < near.end; ++column) {
      const double apart = distance(lattice.point(column, row), place);
      if (apart < best.distance - equal) best = {number + column - columns.begin, apart};
    }
  });
  return best;
}

double most_particles_in(const Body& body, const Region& region) {
  const Lattice& lattice = body.lattice;
  const auto rows = rows_in(lattice, region);
  const auto columns = indices_in(columns_of(region), lattice.first.x, lattice.spacing.x, lattice.columns);
  return static_cast<double>(rows.end - rows.begin) * static_cast<double>(columns.end - columns.begin);
}

void particles_in(const Body& body, const Region& region, std::vector<std::int64_t>& particles) {
  const Lattice& lattice = body.lattice;
  const double slack = tolerance * lattice.spacing.x;
  visit_rows(body, rows_in(lattice, region), [&](std::int64_t row, Lattice::Range columns, std::int64_t number) {
    const double y = lattice.point(0, row).y;
    auto chosen = indices_in(chord(region, y, slack), lattice.first.x, lattice.spacing.x, lattice.columns);
    chosen = {std::max(chosen.begin, columns.begin), std::min(chosen.end, columns.end)};
    for (std::int64_t column = chosen.begin; column < chosen.end; ++column) {
      particles.push_back(number + column - columns.begin);
    }
  });
}

double distance_from(const Region& region, Vector place) {
  if (const Disc* disc = std::get_if<Disc>(&region)) {
    return std::max(0.0, distance(place, disc->centre) - disc->radius);
  }
  const Box& box = std::get<Box>(region);
  return distance(place,
                  {std::clamp(place.x, box.lower.x, box.upper.x), std::clamp(place.y, box.lower.y, box.upper.y)});
}

}  // namespace trajan
