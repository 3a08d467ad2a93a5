#include "solver/contact/nearby_particles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trajan {
namespace {

using Matrix = std::array<Components, 3>;

/// The deformation gradient of a particle; of axes that the grid lacks it is 1.
Matrix deformation_of(int axes, const BodyParticles& body, std::uint32_t i) {
  Matrix gradient{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (!body.has(Attribute::deformation_xx)) return gradient;
  for (int a = 0; a < axes; ++a)
    for (int b = 0; b < axes; ++b)
      gradient[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] =
          body.value(Attribute::deformation_xx, 3 * a + b, i);
  return gradient;
}

Ellipsoid ellipsoid_of(int axes, const BodyParticles& body, const Matrix& gradient) {
  Ellipsoid sum{};
  for (std::size_t b = 0; b < static_cast<std::size_t>(axes); ++b) {
    Components edge{};
    for (std::size_t a = 0; a < static_cast<std::size_t>(axes); ++a)
      edge[a] = gradient[a][b] * body.constants.half_size[b];
    for (std::size_t a = 0; a < 3; ++a) {
      sum[a] += edge[a] * edge[a];
      sum[a == 2 ? 5 : 3 + a] += edge[a == 2 ? 0 : a] * edge[a == 2 ? 2 : a + 1];
    }
  }
  return sum;
}

/// A point of the surface goes along with its particle: F from, and cof F normal (Nanson).
NearbyBoundary moved(const BoundaryPoint& point, const Matrix& f, const Components& place) {
  NearbyBoundary now{place, {}};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t a1 = (a + 1) % 3, a2 = (a + 2) % 3;
    for (std::size_t b = 0; b < 3; ++b) {
      const std::size_t b1 = (b + 1) % 3, b2 = (b + 2) % 3;
      now.place[a] += f[a][b] * point.from[b];
      now.normal[a] += (f[a1][b1] * f[a2][b2] - f[a1][b2] * f[a2][b1]) * point.normal[b];
    }
  }
  const double length = std::sqrt(dot(now.normal, now.normal));
  for (double& component : now.normal) component /= length > 0 ? length : 1;
  return now;
}

/// Along every axis, first and last.
struct Range {
  std::array<int, 3> first, last;
};

/// Where some nodes of a tile, by their bits, lie.
Range range_of(const Layout& layout, std::uint64_t nodes) {
  Range range{{layout.side, layout.side, layout.side}, {-1, -1, -1}};
  for (int node = 0; node < tile_nodes; ++node) {
    if (!(nodes >> node & 1u)) continue;
    const std::array<int, 3> at = {node % layout.side, node / layout.side % layout.side,
                                   node / (layout.side * layout.side)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      range.first[axis] = std::min(range.first[axis], at[axis]);
      range.last[axis] = std::max(range.last[axis], at[axis]);
    }
  }
  return range;
}

/// Nodes of a tile within reach of a place along an axis, first and last.
std::pair<int, int> nodes_near(double place, int side) {
  return {std::max(0, static_cast<int>(std::ceil(place - nearby))),
          std::min(side - 1, static_cast<int>(std::floor(place + nearby)))};
}

/// Calls of(what is near, place from the node) for each of the nodes near a place.
template <class Of>
void for_each_node_near(const Layout& layout, const Components& place, std::uint64_t nodes,
                        std::vector<NearbyParticles*>& near, Of&& of) {
  std::pair<int, int> range[3] = {{0, 0}, {0, 0}, {0, 0}};
  for (int axis = 0; axis < layout.dimensions; ++axis)
    range[axis] = nodes_near(place[static_cast<std::size_t>(axis)], layout.side);
  for (int k = range[2].first; k <= range[2].second; ++k)
    for (int j = range[1].first; j <= range[1].second; ++j)
      for (int i = range[0].first; i <= range[0].second; ++i) {
        const int node = (k * layout.side + j) * layout.side + i;
        if (!(nodes >> node & 1u)) continue;
        const Components from = {place[0] - i, place[1] - j, place[2] - k};
        if (dot(from, from) <= nearby * nearby) of(*near[static_cast<std::size_t>(node)], from);
      }
}

/// Calls of(place, in cells from the tile's first node) for a particle and, where the grid repeats itself, all
/// images of it that are near nodes in a range.
template <class Of>
void for_each_image(const Layout& layout, const SweepConstants& sweep, const Tile& tile, const Range& range,
                    const BodyParticles& body, std::size_t particle, Of&& of) {
  Components first{};
  int count[3] = {1, 1, 1};
  for (int axis = 0; axis < layout.dimensions; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double x = body.component(Attribute::position_x, axis)[particle], period = sweep.period[axis];
    const double lowest = range.first[a] - nearby, highest = range.last[a] + nearby;
    double at = (x - sweep.origin[axis]) * sweep.inverse_cell - layout.side * static_cast<double>(tile.at[axis]);
    if (period > 0) at += period * std::ceil((lowest - at) / period);
    if (at < lowest || at > highest) return;
    if (period > 0) count[axis] += static_cast<int>((highest - at) / period);
    first[a] = at;
  }
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int i = 0; i < count[0]; ++i)
        of({first[0] + i * sweep.period[0], first[1] + j * sweep.period[1], first[2] + k * sweep.period[2]});
}

}  // namespace

Components product(const Ellipsoid& e, const Components& v) {
  return {e[0] * v[0] + e[3] * v[1] + e[5] * v[2], e[3] * v[0] + e[1] * v[1] + e[4] * v[2],
          e[5] * v[0] + e[4] * v[1] + e[2] * v[2]};
}

void find_nearby(const Tiles& tiles, const std::vector<BodyParticles>& bodies,
                 const std::vector<BodySurface>& surfaces, const SweepConstants& sweep, const Tile& tile,
                 std::uint64_t nodes, std::vector<NearbyParticles*>& near) {
  const Layout& layout = tiles.layout();
  const Range range = range_of(layout, nodes);
  tiles.for_each_around(tile, [&](const Tile& other) {
    for (std::uint32_t b = other.first_block; b < other.last_block; ++b) {
      const BlockRange& block = tiles.blocks()[b];
      const BodyParticles& body = bodies[block.body];
      for (std::uint32_t i = block.begin; i < block.begin + block.count; ++i)
        for_each_image(layout, sweep, tile, range, body, i, [&](const Components& place) {
          const Matrix gradient = deformation_of(layout.dimensions, body, i);
          const Ellipsoid ellipsoid = ellipsoid_of(layout.dimensions, body, gradient);
          for_each_node_near(layout, place, nodes, near, [&](NearbyParticles& of_node, const Components& from) {
            of_node.add(from, ellipsoid);
          });
          for (const BoundaryPoint& point : surfaces[block.body].of(body.number[i])) {
            const NearbyBoundary boundary = moved(point, gradient, place);
            for_each_node_near(layout, boundary.place, nodes, near,
                               [&](NearbyParticles& of_node, const Components& from) {
                                 of_node.boundary.push_back({from, boundary.normal});
                               });
          }
        });
    }
  });
}

double reach(const NearbyParticles& near, const Components& along) {
  double close = -std::numeric_limits<double>::infinity(), anywhere = close;
  for (std::size_t p = 0; p < near.places.size(); ++p) {
    const Components& place = near.places[p];
    const double ahead = dot(place, along), to = near.reach(p, along);
    anywhere = std::max(anywhere, to);
    if (dot(place, place) - ahead * ahead <= beside * beside) close = std::max(close, to);
  }
  return std::isinf(close) ? anywhere : close;
}

}  // namespace trajan
