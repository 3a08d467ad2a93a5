#include "solver/loads/loads.h"

#include <algorithm>
#include <cmath>

#include "solver/simulation/particles.h"

namespace trajan {
namespace {

/// Bilinear polynomials of a cell's four nodes, in the order of their indices.
std::array<double, 4> corner_weights(double fx, double fy) {
  return {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
}

}  // namespace

std::vector<Slot> find_slots(const std::vector<BodyParticles>& bodies, const Model& model,
                             const std::vector<std::int64_t>& numbers) {
  std::vector<std::size_t> order(numbers.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return numbers[a] < numbers[b]; });
  std::vector<Slot> slots(numbers.size());
  auto wanted = order.begin();
  for (std::uint32_t b = 0; b < bodies.size() && wanted != order.end(); ++b) {
    const std::int64_t first = model.bodies[b].first_particle, n = model.bodies[b].particles;
    if (numbers[*wanted] >= first + n) continue;
    std::vector<std::uint32_t> slot_of(static_cast<std::size_t>(n));
    for (std::uint32_t slot = 0; slot < n; ++slot) slot_of[bodies[b].number[slot]] = slot;
    for (; wanted != order.end() && numbers[*wanted] < first + n; ++wanted)
      slots[*wanted] = {b, slot_of[static_cast<std::size_t>(numbers[*wanted] - first)]};
  }
  return slots;
}

Loads::Loads(const Model& model, bool total_lagrangian) : model_(model), total_lagrangian_(total_lagrangian) {
  for (const SurfaceLoad& load : model.surface_loads)
    for (const LoadPoint& point : load.points) {
      positions_.push_back(point.position.x);
      positions_.push_back(point.position.y);
    }
}

void Loads::bind(const std::vector<BodyParticles>& bodies, const Tiles& tiles) {
  std::vector<std::int64_t> numbers;
  for (const SurfaceLoad& load : model_.surface_loads)
    for (const LoadPoint& point : load.points) numbers.push_back(point.carrier);
  carriers_ = find_slots(bodies, model_, numbers);
  tiles_.assign(carriers_.size(), 0);
  if (carriers_.empty()) return;
  // Blocks by body and first particle, to find a slot's tile.
  struct Start {
    std::uint32_t body, begin, tile;
  };
  std::vector<Start> starts;
  for (std::uint32_t t = 0; t < tiles.tiles().size(); ++t)
    for (std::uint32_t b = tiles.tiles()[t].first_block; b < tiles.tiles()[t].last_block; ++b)
      starts.push_back({tiles.blocks()[b].body, tiles.blocks()[b].begin, t});
  const auto before = [](const Start& a, const Start& b) {
    return a.body != b.body ? a.body < b.body : a.begin < b.begin;
  };
  std::sort(starts.begin(), starts.end(), before);
  for (std::size_t p = 0; p < carriers_.size(); ++p) {
    const auto after =
        std::upper_bound(starts.begin(), starts.end(), Start{carriers_[p].body, carriers_[p].index, 0}, before);
    tiles_[p] = (after - 1)->tile;
  }
}

void Loads::accelerate(std::vector<BodyParticles>& bodies, double time) const {
  if (model_.body_loads.empty()) return;
  for (BodyParticles& body : bodies) body.constants.acceleration_x = body.constants.acceleration_y = 0;
  for (const BodyLoad& load : model_.body_loads) {
    const double factor = load.time(time);
    for (std::size_t b : load.bodies) {
      bodies[b].constants.acceleration_x += factor * load.acceleration.x;
      bodies[b].constants.acceleration_y += factor * load.acceleration.y;
    }
  }
}

Loads::Stencil Loads::stencil(const Tiles& tiles, const std::vector<BodyParticles>& bodies,
                              std::size_t point) const {
  const Tile& tile = tiles.tiles()[tiles_[point]];
  const BodyParticles& body = bodies[carriers_[point].body];
  const double q = 1 / model_.grid.cell;
  const auto in_window = [&](double position, double origin, std::int32_t tile_index) {
    return (position - origin) * q - (tile_side * static_cast<double>(tile_index) - 1);
  };
  const double cx = in_window(body[Attribute::position_x][carriers_[point].index], model_.grid.origin.x, tile.x);
  const double cy = in_window(body[Attribute::position_y][carriers_[point].index], model_.grid.origin.y, tile.y);
  const double px = in_window(positions_[2 * point], model_.grid.origin.x, tile.x);
  const double py = in_window(positions_[2 * point + 1], model_.grid.origin.y, tile.y);
  const int column = static_cast<int>(cx), row = static_cast<int>(cy);
  return {&tile, row * window_side + column, corner_weights(cx - column, cy - row),
          corner_weights(px - column, py - row)};
}

void Loads::add_to(Tiles& tiles, const std::vector<BodyParticles>& bodies, double time) const {
  std::size_t p = 0;
  for (const SurfaceLoad& load : model_.surface_loads) {
    const double factor = load.time(time);
    for (const LoadPoint& point : load.points) {
      const Stencil s = stencil(tiles, bodies, p);
      double* x = &tiles.sums(tiles_[p])[sum_load_x * window_nodes + s.node];
      double* y = &tiles.sums(tiles_[p])[sum_load_y * window_nodes + s.node];
      for (int n = 0; n < 4; ++n) {
        const int at = n / 2 * window_side + n % 2;
        x[at] += s.of_point[n] * factor * point.force.x;
        y[at] += s.of_point[n] * factor * point.force.y;
      }
      ++p;
    }
  }
}

void Loads::advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, NodeValue gradient,
                   double drift) {
  if (total_lagrangian_) return;
  const auto value = [&tiles](const Tile& tile, int quantity, int node) {
    const int i = node % window_side - 1, j = node / window_side - 1;
    const int across = (i + tile_side) / tile_side, up = (j + tile_side) / tile_side;
    const auto owner = static_cast<std::size_t>(tile.around[up * 3 + across]);
    return tiles.nodes(owner)[quantity * tile_nodes + (j & (tile_side - 1)) * tile_side + (i & (tile_side - 1))];
  };
  for (std::size_t p = 0; p < carriers_.size(); ++p) {
    const Stencil s = stencil(tiles, bodies, p);
    for (int axis = 0; axis < 2; ++axis) {
      double velocity = 0;
      for (std::size_t n = 0; n < 4; ++n) {
        const int node = s.node + static_cast<int>(n / 2 * window_side + n % 2);
        velocity += s.of_carrier[n] * value(*s.tile, node_velocity_x + axis, node) +
                    (s.of_point[n] - s.of_carrier[n]) * value(*s.tile, gradient + axis, node);
      }
      positions_[2 * p + static_cast<std::size_t>(axis)] += drift * velocity;
    }
  }
}

}  // namespace trajan
