#include "solver/model/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "solver/model/names.h"

namespace trajan {

namespace {

auto key(Vector v) { return std::tuple(v.x, v.y, v.z); }

Vector minus(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(Vector a, Vector b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

/// On which side of the edge, seen along x, the line at (y, z) passes: +1 or -1, never 0. The line is moved by
/// infinitesimal amounts, more along y than along z, so that it meets no edge and no corner (Edelsbrunner & Muecke
/// 1990); and both triangles of an edge get the same answer, as it is computed from the lesser corner on.
int side_of(Vector a, Vector b, double y, double z) {
  const bool swap = key(b) < key(a);
  if (swap) std::swap(a, b);
  const double dy = b.y - a.y, dz = b.z - a.z;
  double value = dy * (z - a.z) - dz * (y - a.y);
  if (value == 0) value = -dz;
  if (value == 0) value = dy;
  const int side = value < 0 ? -1 : 1;
  return swap ? -side : side;
}

double squared_distance_from_edge(Vector a, Vector b, Vector p) {
  const Vector along = minus(b, a), from = minus(p, a);
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(from, along) / square, 0.0, 1.0) : 0;
  const Vector off = {from.x - t * along.x, from.y - t * along.y, from.z - t * along.z};
  return dot(off, off);
}

double squared_distance(const Triangle& t, Vector p) {
  const Vector normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  const double square = dot(normal, normal);
  bool above = square > 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector a = t[i], b = t[(i + 1) % 3];
    above = above && dot(cross(normal, minus(b, a)), minus(p, a)) >= 0;
    nearest = std::min(nearest, squared_distance_from_edge(a, b, p));
  }
  const double height = dot(normal, minus(p, t[0]));
  return above ? height * height / square : nearest;
}

}  // namespace

TriangleMesh::TriangleMesh(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
  bounds_ = {triangles_.front()[0], triangles_.front()[0]};
  for (const Triangle& triangle : triangles_) {
    for (const Vector& v : triangle) {
      bounds_.lower = {std::min(bounds_.lower.x, v.x), std::min(bounds_.lower.y, v.y),
                       std::min(bounds_.lower.z, v.z)};
      bounds_.upper = {std::max(bounds_.upper.x, v.x), std::max(bounds_.upper.y, v.y),
                       std::max(bounds_.upper.z, v.z)};
    }
  }
  check_closed();
  if (!(volume() > 0)) throw MeshError("the surface encloses no volume", "give the closed surface of a body");
  fill_bins();
}

void TriangleMesh::check_closed() const {
  using Corner = std::tuple<double, double, double>;
  std::map<std::pair<Corner, Corner>, int> balance;
  for (const Triangle& triangle : triangles_) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner a = key(triangle[i]), b = key(triangle[(i + 1) % 3]);
      if (a == b) continue;  // the triangle's other two edges cancel
      a < b ? ++balance[{a, b}] : --balance[{b, a}];
    }
  }
  std::size_t open = 0;
  const std::pair<const std::pair<Corner, Corner>, int>* first = nullptr;
  for (const auto& entry : balance) {
    if (entry.second == 0) continue;
    if (open++ == 0) first = &entry;
  }
  if (open == 0) return;
  const auto text = [](const Corner& c) {
    return point_text({std::get<0>(c), std::get<1>(c), std::get<2>(c)}, 3);
  };
  throw MeshError("the surface is not closed: along " + std::to_string(open) + " edges, the first from " +
                      text(first->first.first) + " to " + text(first->first.second) +
                      ", not as many triangles of one sense meet as of the other",
                  "close its holes, join corners that should be one, and let all triangles be "
                  "counter-clockwise seen from outside");
}

double TriangleMesh::volume() const {
  // Six times the signed volumes of the tetrahedra below the triangles, seen from one corner of the box.
  double sum = 0;
  for (const Triangle& t : triangles_) {
    const Vector a = minus(t[0], bounds_.lower), b = minus(t[1], bounds_.lower), c = minus(t[2], bounds_.lower);
    sum += dot(a, cross(b, c));
  }
  return std::abs(sum) / 6;
}

std::size_t TriangleMesh::bin_of(double coordinate, double lower, double upper) const {
  const double most = static_cast<double>(bins_ - 1);
  const double bin = std::floor((coordinate - lower) / (upper - lower) * static_cast<double>(bins_));
  return static_cast<std::size_t>(std::clamp(bin, 0.0, most));
}

/// About as many bins as triangles, fewer if triangles would lie in many of them.
void TriangleMesh::fill_bins() {
  struct Range {
    std::size_t y0, y1, z0, z1;
  };
  const auto range_of = [this](const Triangle& t) {
    const auto [y0, y1] = std::minmax({t[0].y, t[1].y, t[2].y});
    const auto [z0, z1] = std::minmax({t[0].z, t[1].z, t[2].z});
    return Range{bin_of(y0, bounds_.lower.y, bounds_.upper.y), bin_of(y1, bounds_.lower.y, bounds_.upper.y),
                 bin_of(z0, bounds_.lower.z, bounds_.upper.z), bin_of(z1, bounds_.lower.z, bounds_.upper.z)};
  };
  const auto entries = [&] {
    std::size_t sum = 0;
    for (const Triangle& t : triangles_) {
      const Range r = range_of(t);
      sum += (r.y1 - r.y0 + 1) * (r.z1 - r.z0 + 1);
    }
    return sum;
  };
  bins_ = 1 + static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles_.size())));
  while (bins_ > 1 && entries() > 8 * triangles_.size()) bins_ = bins_ / 2;
  bins_ = std::max<std::size_t>(bins_, 1);
  std::vector<std::uint32_t> counts(bins_ * bins_ + 1, 0);
  const auto visit = [&](auto of_bin) {
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      const Range r = range_of(triangles_[i]);
      for (std::size_t z = r.z0; z <= r.z1; ++z)
        for (std::size_t y = r.y0; y <= r.y1; ++y) of_bin(z * bins_ + y, i);
    }
  };
  visit([&](std::size_t bin, std::uint32_t) { ++counts[bin + 1]; });
  most_in_a_bin_ = *std::ranges::max_element(counts);
  for (std::size_t b = 1; b < counts.size(); ++b) counts[b] += counts[b - 1];
  first_ = counts;
  binned_.resize(counts.back());
  visit([&](std::size_t bin, std::uint32_t triangle) { binned_[counts[bin]++] = triangle; });
}

std::vector<TriangleMesh::Crossing> TriangleMesh::crossings(double y, double z) const {
  std::vector<Crossing> found;
  if (y < bounds_.lower.y || y > bounds_.upper.y || z < bounds_.lower.z || z > bounds_.upper.z) return found;
  const std::size_t bin =
      bin_of(z, bounds_.lower.z, bounds_.upper.z) * bins_ + bin_of(y, bounds_.lower.y, bounds_.upper.y);
  for (std::uint32_t i = first_[bin]; i < first_[bin + 1]; ++i) {
    const auto& [a, b, c] = triangles_[binned_[i]];
    const int side = side_of(a, b, y, z);
    if (side_of(b, c, y, z) != side || side_of(c, a, y, z) != side) continue;
    const Vector normal = cross(minus(b, a), minus(c, a));
    if (normal.x == 0) continue;  // a triangle along the line, which passes it by
    found.push_back({a.x - (normal.y * (y - a.y) + normal.z * (z - a.z)) / normal.x, -side});
  }
  std::ranges::sort(found, {}, &Crossing::x);
  return found;
}

Spans TriangleMesh::spans(double y, double z, double slack) const {
  Spans spans;
  int winding = 0;
  double entered = 0;
  for (const Crossing& crossing : crossings(y, z)) {
    const int before = winding;
    winding += crossing.sense;
    if (before == 0) entered = crossing.x - slack;
    if (winding != 0) continue;
    const double left = crossing.x + slack;
    if (!spans.empty() && entered <= spans.back().to) {
      spans.back().to = left;
    } else if (entered <= left) {
      spans.push_back({entered, left});
    }
  }
  return spans;
}

double TriangleMesh::signed_distance(Vector place) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : triangles_) nearest = std::min(nearest, squared_distance(triangle, place));
  int winding = 0;
  for (const Crossing& crossing : crossings(place.y, place.z)) {
    if (crossing.x < place.x) winding += crossing.sense;
  }
  return winding != 0 ? -std::sqrt(nearest) : std::sqrt(nearest);
}

}  // namespace trajan
