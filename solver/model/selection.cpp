#include "solver/model/selection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trajan {

namespace {

/// In spacings: more than rounding moves a particle, far less than particles are apart.
constexpr double tolerance = 1e-9;

/// The points of a lattice along an axis.
struct PointsAlong {
  const Lattice& lattice;
  double first, spacing;
  std::int64_t count;

  PointsAlong(const Lattice& of, int axis) : lattice(of) {
    const std::int64_t counts[] = {of.columns, of.rows, of.planes};
    const double firsts[] = {of.first.x, of.first.y, of.first.z};
    const double spacings[] = {of.spacing.x, of.spacing.y, of.spacing.z};
    count = counts[axis], first = firsts[axis], spacing = spacings[axis];
  }
  /// In spacings from the first even place.
  double even(double coordinate) const { return (coordinate - first) / spacing; }
};

/// Indices of the points between two coordinates, half-open and clipped to 0..count.
Lattice::Range indices_in(double lower, double upper, const PointsAlong& points) {
  if (points.spacing == 0) return {0, points.count};
  const double most = static_cast<double>(points.count);
  const double from = points.even(lower) - tolerance, to = points.even(upper) + tolerance;
  const double begin = std::clamp(std::ceil(from), 0.0, most);
  const double end = std::clamp(std::floor(to) + 1, begin, most);
  Lattice::Range range{static_cast<std::int64_t>(begin), static_cast<std::int64_t>(end)};
  const std::int64_t around = points.lattice.unevenness();
  if (around == 0) return range;
  const auto lies = [&](std::int64_t i) { return points.lattice.even(i) >= from && points.lattice.even(i) <= to; };
  range = {std::max<std::int64_t>(0, range.begin - around), std::min(points.count, range.end + around)};
  while (range.begin < range.end && !lies(range.begin)) ++range.begin;
  while (range.begin < range.end && !lies(range.end - 1)) --range.end;
  return range;
}

/// The part of a lattice in a box.
struct LatticePart {
  Lattice::Range columns, rows, planes;

  LatticePart(const Lattice& lattice, const Box& box)
      : columns(indices_in(box.lower.x, box.upper.x, PointsAlong(lattice, 0))),
        rows(indices_in(box.lower.y, box.upper.y, PointsAlong(lattice, 1))),
        planes(indices_in(box.lower.z, box.upper.z, PointsAlong(lattice, 2))) {}
};

double distance(Vector a, Vector b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

/// The two indices next to a coordinate, within the range; of uneven points some more.
Lattice::Range neighbours(double coordinate, const PointsAlong& points, Lattice::Range range) {
  const double below = points.spacing > 0 ? std::floor(points.even(coordinate)) : 0;
  const double more = static_cast<double>(points.lattice.unevenness());
  const auto clamped = [&](double index) {
    return static_cast<std::int64_t>(
        std::clamp(index, static_cast<double>(range.begin), static_cast<double>(range.end - 1)));
  };
  return {clamped(below - more), clamped(below + 1 + more) + 1};
}

/// Rows (or planes) at most `reach` from a coordinate, and two more.
Lattice::Range around(double coordinate, const PointsAlong& points, std::int64_t reach) {
  const Lattice::Range next = neighbours(coordinate, points, {0, points.count});
  return {std::max<std::int64_t>(0, next.begin - reach), std::min(points.count, next.end + reach)};
}

/// The nearest particle of these rows and planes; infinitely far if there is none.
NearestParticle nearest_in(const Body& body, Vector place, Lattice::Range rows, Lattice::Range planes) {
  const Lattice& lattice = body.lattice;
  const double equal = tolerance * lattice.spacing.x;
  NearestParticle best{body.first_particle, std::numeric_limits<double>::infinity()};
  const auto visit = [&](std::int64_t row, Lattice::Range columns, std::int64_t number) {
    const auto candidates = neighbours(place.x, PointsAlong(lattice, 0), columns);
    for (std::int64_t column = candidates.begin; column < candidates.end; ++column) {
      const double apart = distance(lattice.point(column, row), place);
      if (apart < best.distance - equal) best = {body.first_particle + number + column - columns.begin, apart, 0};
    }
  };
  for (std::int64_t plane = planes.begin; plane < planes.end; ++plane)
    lattice.for_each_range(plane * lattice.rows + rows.begin, plane * lattice.rows + rows.end, visit);
  return best;
}

}  // namespace

std::int64_t box_particle(const Body& body, std::int64_t column, std::int64_t row) {
  return body.first_particle + row * body.lattice.columns + column;
}

NearestParticle nearest_particle(const Body& body, Vector place) {
  const Lattice& lattice = body.lattice;
  const double equal = tolerance * lattice.spacing.x;
  const double across = lattice.planes > 1 ? std::min(lattice.spacing.y, lattice.spacing.z) : lattice.spacing.y;
  // A lattice that is not full knows the numbers of 4096 rows and counts from there.
  const double counted = std::ceil(static_cast<double>(lattice.row_count()) / 4096);
  double rows_seen = 0;
  // Rows farther and farther away are looked at until none can be nearer.
  for (std::int64_t reach = 1;; reach *= 2) {
    const auto rows = around(place.y, PointsAlong(lattice, 1), reach);
    const auto planes = around(place.z, PointsAlong(lattice, 2), reach);
    NearestParticle best = nearest_in(body, place, rows, planes);
    rows_seen +=
        static_cast<double>(planes.end - planes.begin) * (static_cast<double>(rows.end - rows.begin) + counted);
    best.rows = rows_seen;
    const bool all = rows.end - rows.begin == lattice.rows && planes.end - planes.begin == lattice.planes;
    if (all || best.distance + equal < static_cast<double>(reach - lattice.unevenness()) * across) return best;
  }
}

double most_particles_in(const Body& body, const Region& region) {
  const LatticePart part(body.lattice, bounds(region));
  return static_cast<double>(part.columns.end - part.columns.begin) *
         static_cast<double>(part.rows.end - part.rows.begin) *
         static_cast<double>(part.planes.end - part.planes.begin);
}

void particles_in(const Body& body, const Region& region, std::vector<std::int64_t>& particles) {
  const Lattice& lattice = body.lattice;
  const LatticePart part(lattice, bounds(region));
  const double slack = tolerance * lattice.spacing.x;
  const auto most = static_cast<std::size_t>(most_particles_in(body, region));
  if (particles.empty()) particles.reserve(std::min(most, static_cast<std::size_t>(body.particles)));
  const auto visit = [&](std::int64_t row, Lattice::Range columns, std::int64_t number) {
    const Vector start = lattice.point(0, row);
    for (const Span& span : spans(region, start.y, start.z, slack)) {
      const auto chosen = indices_in(span.from, span.to, PointsAlong(lattice, 0));
      const std::int64_t end = std::min(chosen.end, columns.end);
      for (std::int64_t column = std::max(chosen.begin, columns.begin); column < end; ++column) {
        const std::int64_t particle = body.first_particle + number + column - columns.begin;
        if (particles.empty() || particles.back() < particle) particles.push_back(particle);
      }
    }
  };
  for (std::int64_t plane = part.planes.begin; plane < part.planes.end; ++plane)
    lattice.for_each_range(plane * lattice.rows + part.rows.begin, plane * lattice.rows + part.rows.end, visit);
}

}  // namespace trajan
