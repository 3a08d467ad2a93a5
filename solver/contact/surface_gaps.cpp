#include "solver/contact/surface_gaps.h"

#include <algorithm>
#include <limits>

#include "solver/contact/nearby_particles.h"
#include "solver/schemes/scheme.h"

namespace trajan {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A node, and what lies near it in the coordinates of the shape.
class NodeView {
 public:
  NodeView(const RigidShape& shape, const Components& node, double cell)
      : shape_(shape), node_(node), cell_(cell) {
    shape.distance(node, normal_);
  }
  /// In cells; `from`: from the node, in cells.
  double distance(const Components& from, Components& normal) const {
    Components at;
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = node_[axis] + cell_ * from[axis];
    return shape_.distance(at, normal) / cell_;
  }
  /// From 1 on the line through the node along the normal to 0.
  double weight(const Components& from) const {
    const double ahead = dot(from, normal_);
    return falling_weight(dot(from, from) - ahead * ahead, beside);
  }

 private:
  const RigidShape& shape_;
  Components node_, normal_;
  double cell_;
};

/// Infinite if no boundary faces the shape.
double gap_of_boundary(const NodeView& view, const std::vector<NearbyBoundary>& boundary) {
  Components normal;
  const auto faces = [&](const NearbyBoundary& point) { return dot(point.normal, normal) < -facing; };
  double foremost = infinite, sum = 0, weights = 0;
  for (const NearbyBoundary& point : boundary)
    if (const double gap = view.distance(point.place, normal); faces(point)) foremost = std::min(foremost, gap);
  for (const NearbyBoundary& point : boundary) {
    const double gap = view.distance(point.place, normal);
    if (!faces(point) || gap > foremost + layer) continue;
    const double weight = view.weight(point.place);
    weights += weight;
    sum += weight * gap;
  }
  return weights > 0 ? sum / weights : foremost;
}

/// In cells, from the node.
double gap_at(const NodeView& view, const NearbyParticles& near) {
  double of_boundary = gap_of_boundary(view, near.boundary), of_centres = infinite, of_particles = infinite;
  for (std::size_t p = 0; p < near.places.size(); ++p) {
    Components normal;
    const double gap = view.distance(near.places[p], normal);
    if (view.weight(near.places[p]) > 0) of_centres = std::min(of_centres, gap);
    const double size = std::sqrt(dot(normal, product(near.ellipsoids[p], normal)));
    of_particles = std::min(of_particles, gap - size);
  }
  return std::min(of_centres, of_boundary < infinite ? of_boundary : of_particles);
}

}  // namespace

bool SurfaceGaps::are_needed(const Model& model) {
  return !is_total_lagrangian(model.numerics.scheme) &&
         std::ranges::any_of(model.conditions, [](const BoundaryCondition& condition) {
           const auto* obstacle = std::get_if<RigidObstacle>(&condition.kind);
           return obstacle && obstacle->separates && !obstacle->bonded;
         });
}

SurfaceGaps::SurfaceGaps(const Model& model, const Tiles& tiles, const std::vector<BodyParticles>& bodies,
                         const SweepConstants& sweep)
    : tiles_(tiles), bodies_(bodies), sweep_(sweep) {
  for (const Body& body : model.bodies) surfaces_.emplace_back(model, body);
}

void SurfaceGaps::find(std::size_t tile, std::uint64_t nodes, const RigidShape& shape,
                       std::span<double> gaps) const {
  // Of each thread: what has been big enough once stays so.
  static thread_local std::vector<NearbyParticles> near(tile_nodes);
  static thread_local std::vector<NearbyParticles*> of_node;
  of_node.clear();
  for (NearbyParticles& at : near) {
    at.clear();
    of_node.push_back(&at);
  }
  const Tile& of = tiles_.tiles()[tile];
  find_nearby(tiles_, bodies_, surfaces_, sweep_, of, nodes, of_node);
  const Layout& layout = tiles_.layout();
  for (int node = 0; node < tile_nodes; ++node) {
    if (!(nodes >> node & 1u)) continue;
    const int at[] = {node % layout.side, node / layout.side % layout.side, node / (layout.side * layout.side)};
    Components place{};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(layout.dimensions); ++axis)
      place[axis] = sweep_.origin[axis] + sweep_.cell * (layout.side * of.at[axis] + at[axis]);
    const auto n = static_cast<std::size_t>(node);
    gaps[n] = sweep_.cell * gap_at(NodeView(shape, place, sweep_.cell), near[n]);
  }
}

}  // namespace trajan
