#include "solver/contact/nearby_particles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trajan {
namespace {

/// Distance from the line along the normal, in cells, up to which particles say whether there is a gap: some of
/// every body, however few particles it has in a cell, and no more, lest curved surfaces touch too early.
constexpr double beside = 0.75;

double half_thickness(int axes, const BodyParticles& body, std::uint32_t i, const Components& along) {
  const bool deforms = !body[Attribute::deformation_xx].empty();
  double square = 0;
  for (int b = 0; b < axes; ++b) {
    double edge = deforms ? 0 : along[static_cast<std::size_t>(b)];
    for (int a = 0; deforms && a < axes; ++a)
      edge += along[static_cast<std::size_t>(a)] * body.component(Attribute::deformation_xx, 3 * a + b)[i];
    edge *= body.constants.half_size[b];
    square += edge * edge;
  }
  return std::sqrt(square);
}

/// Nodes of a tile within reach of a place along an axis, first and last.
std::pair<int, int> nodes_near(double place, int side) {
  return {std::max(0, static_cast<int>(std::ceil(place - nearby))),
          std::min(side - 1, static_cast<int>(std::floor(place + nearby)))};
}

void add_to_nodes(const Layout& layout, const Components& place, Slot particle, std::uint64_t nodes,
                  std::vector<NearbyParticles*>& near) {
  std::pair<int, int> range[3] = {{0, 0}, {0, 0}, {0, 0}};
  for (int axis = 0; axis < layout.dimensions; ++axis)
    range[axis] = nodes_near(place[static_cast<std::size_t>(axis)], layout.side);
  for (int k = range[2].first; k <= range[2].second; ++k)
    for (int j = range[1].first; j <= range[1].second; ++j)
      for (int i = range[0].first; i <= range[0].second; ++i) {
        const int node = (k * layout.side + j) * layout.side + i;
        if (!(nodes >> node & 1u)) continue;
        const Components from = {place[0] - i, place[1] - j, place[2] - k};
        if (dot(from, from) <= nearby * nearby) near[static_cast<std::size_t>(node)]->add(from, particle);
      }
}

/// The particle whose centre is furthest along a unit vector, and how far any particle reaches.
struct Foremost {
  Components centre{};
  double reach;
};

Foremost foremost(int axes, const std::vector<BodyParticles>& bodies, const NearbyParticles& near,
                  const Components& along) {
  double furthest = -std::numeric_limits<double>::infinity();
  Foremost found{{}, furthest};
  for (std::size_t p = 0; p < near.places.size(); ++p) {
    const Slot& particle = near.particles[p];
    const double ahead = dot(near.places[p], along);
    found.reach =
        std::max(found.reach, ahead + half_thickness(axes, bodies[particle.body], particle.index, along));
    if (!(ahead > furthest)) continue;
    furthest = ahead;
    found.centre = near.places[p];
  }
  return found;
}

}  // namespace

void find_nearby(const Tiles& tiles, const std::vector<BodyParticles>& bodies, const SweepConstants& sweep,
                 const Tile& tile, std::uint64_t nodes, std::vector<NearbyParticles*>& near) {
  const Layout& layout = tiles.layout();
  for (int n = 0; n < layout.neighbours; ++n) {
    if (tile.around[n] < 0) continue;
    const Tile& other = tiles.tiles()[static_cast<std::size_t>(tile.around[n])];
    for (std::uint32_t b = other.first_block; b < other.last_block; ++b) {
      const BlockRange& block = tiles.blocks()[b];
      const BodyParticles& body = bodies[block.body];
      for (std::uint32_t i = block.begin; i < block.begin + block.count; ++i) {
        Components place{};
        bool is_near = true;
        for (int axis = 0; axis < layout.dimensions; ++axis) {
          const double x = body.component(Attribute::position_x, axis)[i];
          double at =
              (x - sweep.origin[axis]) * sweep.inverse_cell - layout.side * static_cast<double>(tile.at[axis]);
          if (sweep.period[axis] > 0)
            at -= sweep.period[axis] * std::round((at - 0.5 * layout.side) / sweep.period[axis]);
          is_near = is_near && at >= -nearby && at <= layout.side - 1 + nearby;
          place[static_cast<std::size_t>(axis)] = at;
        }
        if (is_near) add_to_nodes(layout, place, {block.body, i}, nodes, near);
      }
    }
  }
}

double reach(int axes, const std::vector<BodyParticles>& bodies, const NearbyParticles& near,
             const Components& along) {
  double close = -std::numeric_limits<double>::infinity(), anywhere = close;
  for (std::size_t p = 0; p < near.places.size(); ++p) {
    const Components& place = near.places[p];
    const Slot& particle = near.particles[p];
    const double ahead = dot(place, along);
    const double to = ahead + half_thickness(axes, bodies[particle.body], particle.index, along);
    anywhere = std::max(anywhere, to);
    if (dot(place, place) - ahead * ahead <= beside * beside) close = std::max(close, to);
  }
  return std::isinf(close) ? anywhere : close;
}

bool are_apart(int axes, const std::vector<BodyParticles>& bodies, const NearbyParticles& first,
               const NearbyParticles& second, const Components& normal) {
  constexpr int most_iterations = 20;
  Components across = normal;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const double length = std::sqrt(dot(across, across));
    if (!(length > 0)) return false;
    Components along;
    for (std::size_t axis = 0; axis < 3; ++axis) along[axis] = across[axis] / length;
    const Foremost a = foremost(axes, bodies, first, along);
    const Foremost b = foremost(axes, bodies, second, {-along[0], -along[1], -along[2]});
    if (a.reach + b.reach < 0) return true;
    Components between, change;
    for (std::size_t axis = 0; axis < 3; ++axis) between[axis] = b.centre[axis] - a.centre[axis];
    if (iteration == 0) {
      across = between;
      continue;
    }
    // To the point of the line between them that is closest.
    for (std::size_t axis = 0; axis < 3; ++axis) change[axis] = between[axis] - across[axis];
    const double gain = -dot(across, change), square = dot(change, change);
    if (!(gain > 1e-9 * length * length)) return false;
    const double share = std::min(1.0, gain / square);
    for (std::size_t axis = 0; axis < 3; ++axis) across[axis] += share * change[axis];
  }
  return false;
}

}  // namespace trajan
