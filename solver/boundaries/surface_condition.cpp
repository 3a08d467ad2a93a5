#include "solver/boundaries/surface_condition.h"

#include <algorithm>
#include <tuple>

namespace trajan {
namespace {

/// Lines that carry less than this share of the largest one's area only touch the surface's end.
constexpr double least_share = 1e-6;

}  // namespace

SurfaceCondition::SurfaceCondition(const Model& model, std::size_t condition,
                                   const std::vector<SurfacePoint>& points, int normal, bool mean)
    : axes_(grid_axes(model.dimension)),
      riders_(model, points, false, point_functions(model.numerics.shape_functions)),
      condition_(condition),
      normal_(normal),
      mean_(mean) {}

void SurfaceCondition::bind(const std::vector<BodyParticles>& bodies, const Tiles& tiles) {
  riders_.bind(bodies, tiles);
}

void SurfaceCondition::advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift) {
  riders_.advect(tiles, bodies, drift);
}

void SurfaceCondition::find_nodes(const std::vector<BodyParticles>& bodies, const Tiles& tiles) {
  shares_.clear();
  for (std::size_t p = 0; p < riders_.size(); ++p)
    share(tiles, riders_.stencil(tiles, bodies, p), riders_.point(p).area);
  collect();
}

void SurfaceCondition::share(const Tiles& tiles, const Riders::Stencil& stencil, double area) {
  const Layout& layout = tiles.layout();
  Riders::Stencil s = stencil;
  // Along the surface a point that stands for lines of nodes has no need to be where its carrier's polynomials
  // have ended, and weights stay positive.
  for (int axis = 0; axis < axes_ && !mean_; ++axis)
    if (axis != normal_)
      s.of_point[axis] = std::clamp(s.of_point[axis], riders_.functions().lowest, riders_.functions().highest);
  const Riders::Values weights = riders_.weights(s, s.of_point);
  for (int n = 0; n < riders_.corners(); ++n) {
    const Riders::Owner at = riders_.owner(tiles, s.tile, s.node + riders_.corner(n));
    std::int64_t line = 0;
    for (int axis = 0; !mean_ && axis < axes_; ++axis) {
      if (axis == normal_) continue;
      const int in_tile = at.node / layout.tile_stride(axis) % layout.side;
      line = line << 31 | (std::int64_t{tiles.tiles()[at.tile].at[axis]} * layout.side + in_tile);
    }
    shares_.push_back({line, {at.tile, static_cast<std::uint32_t>(at.node), area * weights[n]}});
  }
}

void SurfaceCondition::collect() {
  const auto key = [](const Share& s) { return std::tie(s.line, s.node.tile, s.node.node); };
  std::stable_sort(shares_.begin(), shares_.end(),
                   [&](const Share& a, const Share& b) { return key(a) < key(b); });
  nodes_.clear();
  means_.clear();
  double largest = 0;
  for (std::size_t i = 0; i < shares_.size();) {
    SurfaceMean mean{static_cast<std::uint32_t>(nodes_.size()), 0, 0};
    const std::int64_t line = shares_[i].line;
    for (; i < shares_.size() && shares_[i].line == line; ++i) {
      const SurfaceNode& node = shares_[i].node;
      mean.area += node.weight;
      const bool same =
          nodes_.size() > mean.begin && nodes_.back().tile == node.tile && nodes_.back().node == node.node;
      if (same) nodes_.back().weight += node.weight;
      if (!same) nodes_.push_back(node);
    }
    mean.end = static_cast<std::uint32_t>(nodes_.size());
    largest = std::max(largest, mean.area);
    means_.push_back(mean);
  }
  std::erase_if(means_, [&](const SurfaceMean& mean) { return mean.area <= least_share * largest; });
  for (const SurfaceMean& mean : means_)
    for (std::uint32_t n = mean.begin; n < mean.end; ++n) nodes_[n].weight /= mean.area;
}

double SurfaceCondition::inverse_mass(const Tiles& tiles, const HeldComponents& held, const SurfaceNode& at,
                                      int axis) const {
  if (held[at.tile * tile_nodes + at.node] >> axis & 1u) return 0;
  const double mass = tiles.nodes(at.tile)[tile_array(quantity_mass) + at.node];
  return mass > 0 ? 1 / mass : 0;
}

SurfaceCondition::Mean SurfaceCondition::mean(const Tiles& tiles, const HeldComponents& held,
                                              const SurfaceMean& of, NodeVector vector, int axis) const {
  Mean mean;
  for (std::uint32_t n = of.begin; n < of.end; ++n) {
    const SurfaceNode& at = nodes_[n];
    mean.velocity += at.weight * tiles.nodes(at.tile)[tile_array(quantity(vector, axis, axes_)) + at.node];
    mean.inverse_mass += at.weight * at.weight * inverse_mass(tiles, held, at, axis);
  }
  return mean;
}

void SurfaceCondition::add(Tiles& tiles, const HeldComponents& held, const SurfaceMean& to, NodeVector vector,
                           int axis, double impulse) const {
  for (std::uint32_t n = to.begin; n < to.end; ++n) {
    const SurfaceNode& at = nodes_[n];
    tiles.nodes(at.tile)[tile_array(quantity(vector, axis, axes_)) + at.node] +=
        impulse * at.weight * inverse_mass(tiles, held, at, axis);
  }
}

double SurfaceCondition::give(Tiles& tiles, const HeldComponents& held, const SurfaceMean& to, NodeVector vector,
                              int axis, double value) const {
  const Mean now = mean(tiles, held, to, vector, axis);
  if (!(now.inverse_mass > 0)) return 0;
  const double impulse = (value - now.velocity) / now.inverse_mass;
  add(tiles, held, to, vector, axis, impulse);
  return impulse;
}

SurfaceCondition::Pushed SurfaceCondition::push(Tiles& tiles, const HeldComponents& held, const SurfaceMean& to,
                                                int axis, double impulse, double kick) const {
  add(tiles, held, to, node_velocity, axis, impulse);
  add(tiles, held, to, node_acceleration, axis, impulse / kick);
  return account(tiles, held, to, axis, impulse, kick);
}

SurfaceCondition::Pushed SurfaceCondition::account(const Tiles& tiles, const HeldComponents& held,
                                                   const SurfaceMean& to, int axis, double impulse,
                                                   double kick) const {
  Pushed pushed;
  for (std::uint32_t n = to.begin; n < to.end; ++n) {
    const SurfaceNode& at = nodes_[n];
    if (inverse_mass(tiles, held, at, axis) == 0) continue;
    const double a = tiles.nodes(at.tile)[tile_array(quantity(node_acceleration, axis, axes_)) + at.node];
    const double v = tiles.nodes(at.tile)[tile_array(quantity(node_velocity, axis, axes_)) + at.node];
    pushed.impulse += impulse * at.weight;
    pushed.work += impulse * at.weight * (v - 0.5 * kick * a);
  }
  return pushed;
}

}  // namespace trajan
