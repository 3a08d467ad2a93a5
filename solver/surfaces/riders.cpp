#include "solver/surfaces/riders.h"

#include <algorithm>
#include <cmath>

#include "solver/model/spline_degree.h"
#include "solver/schemes/schemes.h"
#include "solver/simulation/particles.h"
#include "solver/surfaces/spline_faces.h"

namespace trajan {
namespace {

/// In cells: a carrier where other polynomials begin takes those further inside the body. Of the others one
/// belongs to a node that it does not see.
constexpr double at_joint = 1e-9;

Vector inward(const SurfacePoint& point) {
  const Vector &s = point.tangents[0], &t = point.tangents[1];
  const Vector n{s.y * t.z - s.z * t.y, s.z * t.x - s.x * t.z, s.x * t.y - s.y * t.x};
  const double length = std::hypot(n.x, n.y, n.z);
  if (!(length > 0)) return {};
  return {-at_joint * n.x / length, -at_joint * n.y / length, -at_joint * n.z / length};
}

bool has_particles(const Tiles& tiles, std::int32_t index) {
  const Tile& tile = tiles.tiles()[static_cast<std::size_t>(index)];
  return tile.first_block < tile.last_block;
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

Riders::Riders(const Model& model, std::vector<SurfacePoint> points, bool follow, const PointFunctions& functions)
    : model_(model),
      functions_(functions),
      axes_(grid_axes(model.dimension)),
      total_lagrangian_(find_scheme(model.numerics.scheme)->total_lagrangian),
      follow_(follow),
      points_(std::move(points)),
      stride_(follow ? 12 : 3) {
  for (const SurfacePoint& point : points_) {
    const Vector& at = point.position;
    inward_.push_back(inward(point));
    state_.insert(state_.end(), {at.x, at.y, at.z});
    if (!follow) continue;
    state_.insert(state_.end(), {at.x, at.y, at.z});
    for (const Vector& t : point.tangents) state_.insert(state_.end(), {t.x, t.y, t.z});
  }
}

void Riders::bind(const std::vector<BodyParticles>& bodies, const Tiles& tiles) {
  std::vector<std::int64_t> numbers;
  for (const SurfacePoint& point : points_) numbers.push_back(point.carrier);
  carriers_ = find_slots(bodies, model_, numbers);
  tiles_.assign(carriers_.size(), 0);
  find_corners(tiles.layout());
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
    if (tiles.layout().margin == Margin::none) tiles_[p] = tile_inside(tiles, bodies, p);
  }
}

/// The tile of the carrier's cell, or of the one further inside the body if it lies on a face between them.
std::uint32_t Riders::tile_inside(const Tiles& tiles, const std::vector<BodyParticles>& bodies,
                                  std::size_t p) const {
  const Tile& tile = tiles.tiles()[tiles_[p]];
  TileIndex at = tile.at;
  const double begin = begin_of_cells(tiles.layout().reach);
  for (int axis = 0; axis < axes_; ++axis) {
    const double position = bodies[carriers_[p].body].component(Attribute::position_x, axis)[carriers_[p].index];
    const double cell = (position - component(model_.grid.origin, axis)) / model_.grid.cell;
    at[static_cast<std::size_t>(axis)] =
        static_cast<std::int32_t>(std::floor((cell + component(inward_[p], axis) - begin) / tiles.layout().side));
  }
  const std::int32_t inside = tiles.find(at, tile.field);
  return inside >= 0 && has_particles(tiles, inside) ? static_cast<std::uint32_t>(inside) : tiles_[p];
}

void Riders::find_corners(const Layout& layout) {
  corners_ = {0};
  for (int axis = 0; axis < axes_; ++axis) {
    const std::vector<int> before = corners_;
    for (int n = 1; n < functions_.nodes; ++n)
      for (const int at : before) corners_.push_back(at + n * layout.window_stride(axis));
  }
}

Riders::Values Riders::weights(const Stencil& stencil, const double (&place)[3]) const {
  return product(stencil, place, -1);
}

Riders::Values Riders::slopes(const Stencil& stencil, const double (&place)[3], int axis) const {
  return product(stencil, place, axis);
}

/// Functions along the axes, or of one of them the derivative, multiplied for each node.
Riders::Values Riders::product(const Stencil& stencil, const double (&place)[3], int sloped) const {
  Values values;
  values[0] = sloped < 0 ? 1 : 1 / model_.grid.cell;
  const bool to_faces = functions_.folds && splines_keep_degree(model_);
  std::size_t count = 1;
  for (int axis = 0; axis < axes_; ++axis) {
    double weight[most_nodes_along], slope[most_nodes_along];
    double* along = axis == sloped ? slope : weight;
    if (to_faces) {
      const SplineFaces faces{static_cast<double>(stencil.below[axis]),
                              static_cast<double>(functions_.nodes - 1 - stencil.above[axis])};
      faces.weigh(functions_, 0, place[axis], weight, slope);
    } else {
      functions_.weigh(place[axis], weight, slope);
      fold(functions_, stencil.below[axis], stencil.above[axis], along);
    }
    for (auto n = static_cast<std::size_t>(functions_.nodes); n-- > 0;)
      for (std::size_t k = 0; k < count; ++k) values[n * count + k] = values[k] * along[n];
    count *= static_cast<std::size_t>(functions_.nodes);
  }
  return values;
}

Riders::Stencil Riders::stencil(const Tiles& tiles, const std::vector<BodyParticles>& bodies, std::size_t p,
                                Of of) const {
  const Tile& tile = tiles.tiles()[tiles_[p]];
  const Layout& layout = tiles.layout();
  const BodyParticles& body = bodies[carriers_[p].body];
  Stencil stencil{tiles_[p], 0};
  const bool to_faces = functions_.folds && splines_keep_degree(model_);
  for (int axis = 0; axis < axes_; ++axis) {
    const double origin = component(model_.grid.origin, axis);
    const double at = body.component(Attribute::position_x, axis)[carriers_[p].index];
    // In cells from the window's first node. Nodes exist around the cells in which the tile's particles may be.
    const double to_nodes = layout.below - 1 + begin_of_cells(layout.reach);
    const double lowest = tile.cells.lowest[axis] + to_nodes,
                 highest = tile.cells.highest[axis] + to_nodes + 1 - 1e-9;
    double first = layout.side * static_cast<double>(tile.at[axis]) - layout.below;
    double carrier = (at - origin) / model_.grid.cell - first;
    const int period = tiles.period(axis);
    if (period > 0) {
      const double passed = period * std::floor((carrier - lowest) / period);
      first += passed;
      carrier -= passed;
    }
    const double point =
        (state_[stride_ * p + static_cast<std::size_t>(axis)] - origin) / model_.grid.cell - first;
    const double reach = of == Of::force && functions_.averaged ? body.constants.half_size[axis] : 0;
    const double inner = carrier + std::clamp(point - carrier, -reach, reach) + component(inward_[p], axis);
    int node = static_cast<int>(functions_.first_node(std::max(lowest, std::min(inner, highest))));
    const auto cells = static_cast<double>(model_.grid.cells()[static_cast<std::size_t>(axis)]);
    if (to_faces && period == 0) node = SplineFaces{-first, cells - first}.inside(node, functions_);
    stencil.of_carrier[axis] = carrier - node;
    stencil.of_point[axis] = point - node;
    stencil.node += node * layout.window_stride(axis);
    if (!functions_.folds) continue;
    const auto most = static_cast<double>(functions_.nodes), least = to_faces ? -most : 0.0;
    const double below = period > 0 ? least : -first - node;
    const double above = period > 0 ? least : first + node + functions_.nodes - 1 - cells;
    stencil.below[axis] = static_cast<int>(std::clamp(below, least, most));
    stencil.above[axis] = static_cast<int>(std::clamp(above, least, most));
  }
  return stencil;
}

Riders::Owner Riders::owner(const Tiles& tiles, std::uint32_t tile, int window_node) const {
  const Layout& layout = tiles.layout();
  TileIndex from_first{};
  int neighbour = 0, node = 0, power = 1;
  for (int axis = 0; axis < axes_; ++axis, power *= 3) {
    const int i = window_node / layout.window_stride(axis) % layout.window_side - layout.below;
    from_first[static_cast<std::size_t>(axis)] = i;
    neighbour += (i + layout.side) / layout.side * power;
    node += (i & (layout.side - 1)) * layout.tile_stride(axis);
  }
  if (tiles.period().any()) {
    const Tiles::Owner owner = tiles.owner(tiles.tiles()[tile], from_first);
    return {static_cast<std::uint32_t>(owner.tile), owner.node};
  }
  return {static_cast<std::uint32_t>(tiles.tiles()[tile].around[neighbour]), node};
}

Vector Riders::area(std::size_t p) const {
  const SurfacePoint& point = points_[p];
  if (axes_ == 1) return {point.tangents[0].y > 0 ? point.area : -point.area, 0, 0};
  const double* state = &state_[stride_ * p];
  const double *s = state + 6, *t = state + 9;
  const bool hoop = model_.dimension == Dimension::axisymmetric;
  const double scale = hoop ? state[3] : axes_ == 2 ? model_.thickness : 1.0;
  return {scale * (s[1] * t[2] - s[2] * t[1]), scale * (s[2] * t[0] - s[0] * t[2]),
          scale * (s[0] * t[1] - s[1] * t[0])};
}

void Riders::advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift) {
  if (total_lagrangian_ && !follow_) return;
  for (std::size_t p = 0; p < points_.size(); ++p) advect(tiles, stencil(tiles, bodies, p), p, drift);
}

void Riders::displace(const Tiles& tiles, const std::vector<BodyParticles>& bodies) {
  whole_motion_ = true;
  advect(tiles, bodies, 1);
  whole_motion_ = false;
}

void Riders::advect(const Tiles& tiles, const Stencil& s, std::size_t p, double drift) {
  const Values of_carrier = weights(s, s.of_carrier), of_point = weights(s, s.of_point);
  Values slope[3];
  for (int axis = 0; follow_ && axis < axes_; ++axis) slope[axis] = slopes(s, s.of_point, axis);
  double velocity[3] = {}, gradient[3][3] = {};
  for (int n = 0; n < corners(); ++n) {
    const Owner at = owner(tiles, s.tile, s.node + corner(n));
    const double* nodes = tiles.nodes(at.tile) + at.node;
    for (int axis = 0; axis < axes_; ++axis) {
      const double mapped = nodes[tile_array(quantity(node_mapped_velocity, axis, axes_))];
      velocity[axis] += of_carrier[n] * nodes[tile_array(quantity(node_velocity, axis, axes_))] +
                        (of_point[n] - of_carrier[n]) * mapped;
      for (int along = 0; follow_ && along < axes_; ++along) gradient[axis][along] += slope[along][n] * mapped;
    }
  }
  double* state = &state_[stride_ * p];
  for (int axis = 0; axis < axes_; ++axis) {
    if (!total_lagrangian_) state[axis] += drift * velocity[axis];
    if (follow_) state[3 + axis] += drift * velocity[axis];
  }
  if (follow_) turn(gradient, p, drift);
}

/// Tangents are material: dT/dt = Grad v T_0 with the gradient in the reference configuration, or grad v T, which
/// is taken to second order, so that they keep their lengths as the body turns.
void Riders::turn(const double (&gradient)[3][3], std::size_t p, double drift) {
  for (int which = 0; which < 2; ++which) {
    double* t = &state_[stride_ * p + 6 + 3 * static_cast<std::size_t>(which)];
    const Vector& rest = points_[p].tangents[static_cast<std::size_t>(which)];
    double change[3] = {}, again[3] = {};
    for (int i = 0; i < axes_; ++i)
      for (int j = 0; j < axes_; ++j)
        change[i] += drift * gradient[i][j] * (total_lagrangian_ ? component(rest, j) : t[j]);
    for (int i = 0; i < axes_ && !total_lagrangian_ && !whole_motion_; ++i)
      for (int j = 0; j < axes_; ++j) again[i] += drift * gradient[i][j] * change[j];
    for (int i = 0; i < axes_; ++i) t[i] += change[i] + 0.5 * again[i];
  }
}

}  // namespace trajan
