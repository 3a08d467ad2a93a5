#include "solver/model/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trajan {

namespace {

/// Twice the area of the triangle, > 0 if r lies to the left of the way from p to q.
double orientation(Vector p, Vector q, Vector r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); }

int side(Vector p, Vector q, Vector r) {
  const double o = orientation(p, q, r);
  return o > 0 ? 1 : o < 0 ? -1 : 0;
}

/// Whether r, which is on the line through p and q, lies between them.
bool between(Vector p, Vector q, Vector r) {
  return r.x >= std::min(p.x, q.x) && r.x <= std::max(p.x, q.x) && r.y >= std::min(p.y, q.y) &&
         r.y <= std::max(p.y, q.y);
}

bool meet(Vector a, Vector b, Vector c, Vector d) {
  const int abc = side(a, b, c), abd = side(a, b, d), cda = side(c, d, a), cdb = side(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) || (cda == 0 && between(c, d, a)) ||
         (cdb == 0 && between(c, d, b));
}

double distance_from_edge(Vector a, Vector b, Vector p) {
  const double x = b.x - a.x, y = b.y - a.y;
  const double t = std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y), 0.0, 1.0);
  return std::hypot(p.x - a.x - t * x, p.y - a.y - t * y);
}

/// Calls visit(begin, end) for all edges.
template <class Visit>
void for_each_edge(const Polygon& polygon, Visit visit) {
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    visit(polygon.corners[i], polygon.corners[(i + 1) % polygon.corners.size()]);
  }
}

}  // namespace

Box bounds_of(const Polygon& polygon) {
  Box box = {polygon.corners.front(), polygon.corners.front()};
  for (const Vector& corner : polygon.corners) {
    box.lower = {std::min(box.lower.x, corner.x), std::min(box.lower.y, corner.y), 0};
    box.upper = {std::max(box.upper.x, corner.x), std::max(box.upper.y, corner.y), 0};
  }
  return box;
}

Spans spans_of(const Polygon& polygon, double y, double slack) {
  std::vector<double> crossings;
  // An edge has its lower end and not its upper one, so that a corner between two edges counts once.
  for_each_edge(polygon, [&](Vector a, Vector b) {
    if ((a.y <= y) == (b.y <= y)) return;
    crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
  });
  std::ranges::sort(crossings);
  Spans spans;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const double from = crossings[i] - slack, to = crossings[i + 1] + slack;
    if (!spans.empty() && from <= spans.back().to) {
      spans.back().to = to;
    } else if (from <= to) {
      spans.push_back({from, to});
    }
  }
  return spans;
}

double distance_of(const Polygon& polygon, Vector place) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for_each_edge(polygon, [&](Vector a, Vector b) {
    nearest = std::min(nearest, distance_from_edge(a, b, place));
    const bool crosses = (a.y <= place.y) != (b.y <= place.y);
    if (crosses && a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x) > place.x) inside = !inside;
  });
  return inside ? -nearest : nearest;
}

int first_crossing(const Polygon& polygon) {
  const auto& c = polygon.corners;
  const std::size_t n = c.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector a = c[i], b = c[(i + 1) % n], next = c[(i + 2) % n];
    // Neighbours share a corner and must not have more than that.
    const bool none = a.x == b.x && a.y == b.y;
    const bool folds = side(a, b, next) == 0 && (next.x - b.x) * (b.x - a.x) + (next.y - b.y) * (b.y - a.y) < 0;
    if (none || folds) return static_cast<int>(i);
    for (std::size_t j = i + 2; j < n && !(i == 0 && j == n - 1); ++j) {
      if (meet(a, b, c[j], c[(j + 1) % n])) return static_cast<int>(i);
    }
  }
  return -1;
}

}  // namespace trajan
