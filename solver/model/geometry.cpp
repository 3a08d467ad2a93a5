#include "solver/model/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/model/overloaded.h"
#include "solver/model/polygon.h"
#include "solver/model/triangle_mesh.h"

namespace trajan {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Box nothing = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};

Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(Vector a) { return std::hypot(a.x, a.y, a.z); }

Box hull(const Box& a, const Box& b) {
  return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y), std::min(a.lower.z, b.lower.z)},
          {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y), std::max(a.upper.z, b.upper.z)}};
}

Box overlap(const Box& a, const Box& b) {
  return {{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y), std::max(a.lower.z, b.lower.z)},
          {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y), std::min(a.upper.z, b.upper.z)}};
}

Box around(Vector centre, double x, double y, double z) {
  return {{centre.x - x, centre.y - y, centre.z - z}, {centre.x + x, centre.y + y, centre.z + z}};
}

/// A disc reaches as far as a flat cylinder's end does: r sqrt(1 - u^2) along an axis with direction cosine u.
Box bounds_of(const Cylinder& cylinder) {
  const Vector along = cylinder.to - cylinder.from;
  const double l = length(along);
  const auto reach = [&](double u) { return cylinder.radius * std::sqrt(std::max(0.0, 1 - (u / l) * (u / l))); };
  const double x = reach(along.x), y = reach(along.y), z = reach(along.z);
  return hull(around(cylinder.from, x, y, z), around(cylinder.to, x, y, z));
}

Spans one(double from, double to) { return from <= to ? Spans{{from, to}} : Spans{}; }

/// Where a ball of this radius is met at this squared distance of the line from its centre.
Spans chord(double centre, double squared_distance, double radius) {
  const double square = radius * radius - squared_distance;
  if (radius < 0 || square < 0) return {};
  return one(centre - std::sqrt(square), centre + std::sqrt(square));
}

Spans spans_of(const Box& box, double y, double z, double slack) {
  const bool beside = y < box.lower.y - slack || y > box.upper.y + slack;
  const bool below = z < box.lower.z - slack || z > box.upper.z + slack;
  return beside || below ? Spans{} : one(box.lower.x - slack, box.upper.x + slack);
}

/// The line is at p + x e_x; along the cylinder's axis it is at t = t0 + x u, and its distance from the axis
/// is the length of q + x w, where q and w are the parts of p and e_x across the axis.
Spans spans_of(const Cylinder& cylinder, double y, double z, double slack) {
  const double radius = cylinder.radius + slack;
  if (radius < 0) return {};
  Vector axis = cylinder.to - cylinder.from;
  const double l = length(axis);
  axis = {axis.x / l, axis.y / l, axis.z / l};
  const Vector p = {0, y - cylinder.from.y, z - cylinder.from.z};
  const double t0 = dot(p, axis), u = axis.x;
  const Vector q = {p.x - t0 * axis.x, p.y - t0 * axis.y, p.z - t0 * axis.z};
  const Vector w = {1 - u * axis.x, -u * axis.y, -u * axis.z};
  double from = -infinity, to = infinity;
  const double ends[] = {-slack - t0, l + slack - t0};
  if (u != 0) {
    from = std::min(ends[0] / u, ends[1] / u);
    to = std::max(ends[0] / u, ends[1] / u);
  } else if (ends[0] > 0 || ends[1] < 0) {
    return {};
  }
  const double a = dot(w, w), b = dot(q, w), c = dot(q, q) - radius * radius;
  // Parallel to the axis but for rounding.
  if (a < 1e-24) return c > 0 ? Spans{} : one(cylinder.from.x + from, cylinder.from.x + to);
  const double square = b * b - a * c;
  if (square < 0) return {};
  from = std::max(from, (-b - std::sqrt(square)) / a);
  to = std::min(to, (-b + std::sqrt(square)) / a);
  return one(cylinder.from.x + from, cylinder.from.x + to);
}

Spans unite(const Spans& a, const Spans& b) {
  Spans all(a.size() + b.size());
  std::ranges::merge(a, b, all.begin(), {}, &Span::from, &Span::from);
  Spans joined;
  for (const Span& span : all) {
    if (!joined.empty() && span.from <= joined.back().to) {
      joined.back().to = std::max(joined.back().to, span.to);
    } else {
      joined.push_back(span);
    }
  }
  return joined;
}

Spans intersect(const Spans& a, const Spans& b) {
  Spans common;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double from = std::max(a[i].from, b[j].from), to = std::min(a[i].to, b[j].to);
    if (from <= to) common.push_back({from, to});
    (a[i].to < b[j].to ? i : j) += 1;
  }
  return common;
}

Spans subtract(const Spans& a, const Spans& b) {
  Spans rest;
  std::size_t first = 0;
  for (const Span& span : a) {
    double from = span.from;
    while (first < b.size() && b[first].to < from) ++first;
    for (std::size_t j = first; j < b.size() && b[j].from <= span.to; ++j) {
      if (b[j].from >= from) rest.push_back({from, b[j].from});
      from = std::max(from, b[j].to);
    }
    if (from <= span.to) rest.push_back({from, span.to});
  }
  return rest;
}

/// first (operation) second (operation) third …
template <class Value, class Of, class Operation>
Value combine(const std::vector<Part>& parts, Of of, Operation operation) {
  Value value = of(parts.front().region, true);
  for (std::size_t i = 1; i < parts.size(); ++i) value = operation(value, of(parts[i].region, false));
  return value;
}

double distance_of(const Box& box, Vector p) {
  const double x = std::max(box.lower.x - p.x, p.x - box.upper.x);
  const double y = std::max(box.lower.y - p.y, p.y - box.upper.y);
  const double z = std::max(box.lower.z - p.z, p.z - box.upper.z);
  if (x > 0 || y > 0 || z > 0) return std::hypot(std::max(0.0, x), std::max(0.0, y), std::max(0.0, z));
  // Along an axis that the dimension does not have a box is flat and its faces do not count.
  const auto face = [](double inside, double lower, double upper) { return lower < upper ? inside : -infinity; };
  const double nearest = std::max(
      {face(x, box.lower.x, box.upper.x), face(y, box.lower.y, box.upper.y), face(z, box.lower.z, box.upper.z)});
  return std::isfinite(nearest) ? nearest : 0;
}

double distance_of(const Cylinder& cylinder, Vector p) {
  const Vector along = cylinder.to - cylinder.from, from = p - cylinder.from;
  const double l = length(along), t = dot(from, along) / l;
  const double across = std::sqrt(std::max(0.0, dot(from, from) - t * t)) - cylinder.radius;
  const double end = std::max(-t, t - l);
  if (across > 0 && end > 0) return std::hypot(across, end);
  return std::max(across, end);
}

}  // namespace

Box bounds(const Region& region) {
  const auto of = [](const Region& part, bool) { return bounds(part); };
  return std::visit(
      Overloaded{[](std::monostate) { return nothing; }, [](const Box& box) { return box; },
                 [](const Disc& d) { return around(d.centre, d.radius, d.radius, 0); },
                 [](const Sphere& s) { return around(s.centre, s.radius, s.radius, s.radius); },
                 [](const Cylinder& c) { return bounds_of(c); }, [](const Polygon& p) { return bounds_of(p); },
                 [](const Mesh& mesh) { return mesh.surface->bounds(); },
                 [&](const Union& u) { return combine<Box>(u.regions, of, hull); },
                 [&](const Intersection& i) { return combine<Box>(i.regions, of, overlap); },
                 [&](const Difference& d) { return bounds(d.regions.front().region); }},
      region);
}

Spans spans(const Region& region, double y, double z, double slack) {
  const auto same = [&](const Region& part, bool) { return spans(part, y, z, slack); };
  // What is taken away shrinks where the rest grows.
  const auto opposite = [&](const Region& part, bool first) { return spans(part, y, z, first ? slack : -slack); };
  return std::visit(
      Overloaded{
          [](std::monostate) { return Spans{}; }, [&](const Box& box) { return spans_of(box, y, z, slack); },
          [&](const Disc& d) { return chord(d.centre.x, (y - d.centre.y) * (y - d.centre.y), d.radius + slack); },
          [&](const Sphere& s) {
            const double dy = y - s.centre.y, dz = z - s.centre.z;
            return chord(s.centre.x, dy * dy + dz * dz, s.radius + slack);
          },
          [&](const Cylinder& c) { return spans_of(c, y, z, slack); },
          [&](const Polygon& p) { return spans_of(p, y, slack); },
          [&](const Mesh& mesh) { return mesh.surface->spans(y, z, slack); },
          [&](const Union& u) { return combine<Spans>(u.regions, same, unite); },
          [&](const Intersection& i) { return combine<Spans>(i.regions, same, intersect); },
          [&](const Difference& d) { return combine<Spans>(d.regions, opposite, subtract); }},
      region);
}

double signed_distance(const Region& region, Vector p) {
  const auto of = [&](const Region& part, bool) { return signed_distance(part, p); };
  return std::visit(
      Overloaded{[](std::monostate) { return infinity; }, [&](const Box& box) { return distance_of(box, p); },
                 [&](const Disc& d) { return std::hypot(p.x - d.centre.x, p.y - d.centre.y) - d.radius; },
                 [&](const Sphere& s) { return length(p - s.centre) - s.radius; },
                 [&](const Cylinder& c) { return distance_of(c, p); },
                 [&](const Polygon& polygon) { return distance_of(polygon, p); },
                 [&](const Mesh& mesh) { return mesh.surface->signed_distance(p); },
                 [&](const Union& u) {
                   return combine<double>(u.regions, of, [](double a, double b) { return std::min(a, b); });
                 },
                 [&](const Intersection& i) {
                   return combine<double>(i.regions, of, [](double a, double b) { return std::max(a, b); });
                 },
                 [&](const Difference& d) {
                   return combine<double>(d.regions, of, [](double a, double b) { return std::max(a, -b); });
                 }},
      region);
}

double distance_from(const Region& region, Vector place) { return std::max(0.0, signed_distance(region, place)); }

double work_of_a_line(const Region& region) {
  const auto of = [](const Region& part, bool) { return work_of_a_line(part); };
  const auto sum = [&](const auto& set) { return combine<double>(set.regions, of, std::plus<>()); };
  return std::visit(
      Overloaded{[](const auto&) { return 1.0; },
                 [](const Polygon& polygon) { return static_cast<double>(polygon.corners.size()); },
                 [](const Mesh& mesh) { return mesh.surface->work_of_a_line(); },
                 [&](const Union& u) { return sum(u); }, [&](const Intersection& i) { return sum(i); },
                 [&](const Difference& d) { return sum(d); }},
      region);
}

}  // namespace trajan
