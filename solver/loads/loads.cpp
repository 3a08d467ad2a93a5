#include "solver/loads/loads.h"

#include <algorithm>
#include <cmath>

#include "solver/simulation/particles.h"

namespace trajan {
namespace {

/// Multilinear polynomials of a cell's nodes, in the order of their indices.
std::array<double, 8> corner_weights(const double (&f)[3], int axes) {
  std::array<double, 8> weights;
  for (unsigned n = 0; n < weights.size(); ++n) {
    weights[n] = n >> axes ? 0.0 : 1.0;
    for (int axis = 0; axis < axes; ++axis) weights[n] *= n >> axis & 1u ? f[axis] : 1 - f[axis];
  }
  return weights;
}

double component(const Vector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

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

Loads::Loads(const Model& model, bool total_lagrangian)
    : model_(model), axes_(grid_axes(model.dimension)), total_lagrangian_(total_lagrangian) {
  for (const SurfaceLoad& load : model.surface_loads)
    for (const LoadPoint& point : load.points) {
      positions_.insert(positions_.end(), {point.position.x, point.position.y, point.position.z});
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
  for (BodyParticles& body : bodies)
    for (double& a : body.constants.acceleration) a = 0;
  for (const BodyLoad& load : model_.body_loads) {
    const double factor = load.time(time);
    for (std::size_t b : load.bodies)
      for (int axis = 0; axis < axes_; ++axis)
        bodies[b].constants.acceleration[axis] += factor * component(load.acceleration, axis);
  }
}

int Loads::corner(const Layout& layout, int n) const {
  int at = 0;
  for (int axis = 0; axis < axes_; ++axis) at += (n >> axis & 1) * layout.window_stride(axis);
  return at;
}

Loads::Stencil Loads::stencil(const Tiles& tiles, const std::vector<BodyParticles>& bodies,
                              std::size_t point) const {
  const Tile& tile = tiles.tiles()[tiles_[point]];
  const Layout& layout = tiles.layout();
  const BodyParticles& body = bodies[carriers_[point].body];
  Stencil stencil{&tile, layout.corner_offset(), {}, {}};
  double carrier[3] = {}, place[3] = {};
  for (int axis = 0; axis < axes_; ++axis) {
    const double origin = component(model_.grid.origin, axis), first = layout.side * double{1} * tile.at[axis] - 1;
    const double at = body.component(Attribute::position_x, axis)[carriers_[point].index];
    const double c = (at - origin) / model_.grid.cell - first;
    const int cell = static_cast<int>(c);
    carrier[axis] = c - cell;
    place[axis] =
        (positions_[3 * point + static_cast<std::size_t>(axis)] - origin) / model_.grid.cell - first - cell;
    stencil.node += cell * layout.window_stride(axis);
  }
  stencil.of_carrier = corner_weights(carrier, axes_);
  stencil.of_point = corner_weights(place, axes_);
  return stencil;
}

void Loads::add_to(Tiles& tiles, const std::vector<BodyParticles>& bodies, double time) const {
  const Layout& layout = tiles.layout();
  std::size_t p = 0;
  for (const SurfaceLoad& load : model_.surface_loads) {
    const double factor = load.time(time);
    for (const LoadPoint& point : load.points) {
      const Stencil s = stencil(tiles, bodies, p);
      for (int axis = 0; axis < axes_; ++axis) {
        double* sums = tiles.sums(tiles_[p]) + quantity(sum_load, axis, axes_) * layout.window_nodes + s.node;
        for (int n = 0; n < 1 << axes_; ++n)
          sums[corner(layout, n)] += s.of_point[n] * factor * component(point.force, axis);
      }
      ++p;
    }
  }
}

void Loads::advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift) {
  if (total_lagrangian_) return;
  const Layout& layout = tiles.layout();
  const auto value = [&](const Tile& tile, int which, int window_node) {
    int neighbour = 0, node = 0, power = 1;
    for (int axis = 0; axis < axes_; ++axis, power *= 3) {
      const int i = window_node / layout.window_stride(axis) % layout.window_side - layout.below;
      neighbour += (i + layout.side) / layout.side * power;
      node += (i & (layout.side - 1)) * layout.tile_stride(axis);
    }
    return tiles.nodes(static_cast<std::size_t>(tile.around[neighbour]))[which * tile_nodes + node];
  };
  for (std::size_t p = 0; p < carriers_.size(); ++p) {
    const Stencil s = stencil(tiles, bodies, p);
    for (int axis = 0; axis < axes_; ++axis) {
      double velocity = 0;
      for (int n = 0; n < 1 << axes_; ++n) {
        const int node = s.node + corner(layout, n);
        velocity +=
            s.of_carrier[n] * value(*s.tile, quantity(node_velocity, axis, axes_), node) +
            (s.of_point[n] - s.of_carrier[n]) * value(*s.tile, quantity(node_mapped_velocity, axis, axes_), node);
      }
      positions_[3 * p + static_cast<std::size_t>(axis)] += drift * velocity;
    }
  }
}

}  // namespace trajan
