#include "solver/boundaries/rigid_contact.h"

#include <algorithm>
#include <cmath>

namespace trajan {
namespace {

/// Nodes this close to a surface, in cells, are on it.
constexpr double on_surface_within = 1e-9;

/// A normal that has lost more than this to components that are prescribed has no direction.
constexpr double least_normal = 1e-6;

}  // namespace

void RigidContact::make(const Model& model, std::vector<std::unique_ptr<Condition>>& conditions) {
  for (std::size_t i = 0; i < model.conditions.size(); ++i)
    if (const auto* obstacle = std::get_if<RigidObstacle>(&model.conditions[i].kind))
      conditions.push_back(std::make_unique<RigidContact>(model, *obstacle, i));
}

RigidContact::RigidContact(const Model& model, const RigidObstacle& obstacle, std::size_t condition)
    : obstacle_(obstacle), condition_(condition), frame_(model), velocities_(model) {
  shape_.normal = {obstacle.normal.x, obstacle.normal.y, obstacle.normal.z};
  shape_.ball = obstacle.ball;
  shape_.radius = obstacle.radius;
  shape_.point = {obstacle.point.x, obstacle.point.y, obstacle.point.z};
  for (std::size_t axis = 0; axis < 3; ++axis)
    shape_.period[axis] = frame_.cell * static_cast<double>(frame_.period[axis]);
}

void RigidContact::bind(std::span<const TileNodes> tiles, HeldComponents& held) {
  held_ = &held;
  touches_.assign(tiles.size() * TileNodes::count, Touch::none);
  bound_at_ = shape_.point;
  travelled_ = 0;
  distances_.clear();
  for (const TileNodes& nodes : tiles) {
    const Vector a = frame_.place(nodes, 0), b = frame_.place(nodes, TileNodes::count - 1);
    const double to_corner = 0.5 * std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
    Components normal;
    distances_.push_back(shape_.distance({(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}, normal) - to_corner -
                         frame_.cell);
  }
}

/// What sticks for good or may not part is held from the first, wherever its surface goes by rounding.
void RigidContact::measure_gaps_by(const BodyGaps& gaps) {
  if (obstacle_.separates && !obstacle_.bonded) gaps_ = &gaps;
}

void RigidContact::prepare(const Kick& kick) {
  kick_ = kick.length();
  // At a sample particles stand still, and go on with the next kick.
  closing_time_ = kick.drift > 0 ? kick.drift : 2 * kick_;
  shape_.point = {obstacle_.point.x, obstacle_.point.y, obstacle_.point.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::optional<Formula>& u = obstacle_.displacement[axis];
    if (!u) continue;
    shape_.point[axis] += (*u)({}, kick.time);
    velocity_[axis] = velocities_.of(*u, true, {}, kick).after;
  }
  travelled_ =
      std::hypot(shape_.point[0] - bound_at_[0], shape_.point[1] - bound_at_[1], shape_.point[2] - bound_at_[2]);
}

double RigidContact::distance(const TileNodes& nodes, int node, Components& normal) const {
  const Vector at = frame_.place(nodes, node);
  return shape_.distance({at.x, at.y, at.z}, normal);
}

Components RigidContact::relative_velocity(const TileNodes& nodes, int node) const {
  Components relative{};
  for (int axis = 0; axis < frame_.dimensions; ++axis)
    relative[static_cast<std::size_t>(axis)] =
        nodes.velocity(axis)[node] - velocity_[static_cast<std::size_t>(axis)];
  return relative;
}

void RigidContact::find_allowed(std::size_t tile, const TileNodes& nodes,
                                std::array<double, TileNodes::count>& allowed) const {
  allowed.fill(0);
  if (!gaps_) return;
  std::uint64_t closing = 0;
  for (int node = 0; node < TileNodes::count; ++node) {
    Components normal;
    if (!(nodes.mass()[node] > 0) || distance(nodes, node, normal) > on_surface_within * frame_.cell) continue;
    closing |= std::uint64_t{dot(relative_velocity(nodes, node), normal) < 0} << node;
  }
  if (closing == 0) return;
  gaps_->find(tile, closing, shape_, allowed);
  for (double& gap : allowed) gap = std::max(gap, 0.0) / closing_time_;
}

RigidContact::Touch RigidContact::respond(const Components& relative, Components normal, double allowed,
                                          unsigned held, Components& change) const {
  change = {};
  Components free = relative;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (held >> axis & 1u) free[axis] = normal[axis] = 0;
  if (obstacle_.bonded) {
    for (std::size_t axis = 0; axis < 3; ++axis) change[axis] = -free[axis];
    return Touch::sticks;
  }
  const double length = std::sqrt(dot(normal, normal));
  if (length < least_normal) return Touch::none;
  for (double& component : normal) component /= length;
  const double approach = -dot(free, normal) - allowed;
  if (approach <= 0 && obstacle_.separates) return Touch::none;
  Components along;
  for (std::size_t axis = 0; axis < 3; ++axis) along[axis] = free[axis] + (approach + allowed) * normal[axis];
  const double sliding = std::sqrt(dot(along, along));
  const double friction = obstacle_.friction * std::max(0.0, approach);
  const bool sticks = sliding <= friction;
  const double share = sticks ? 1 : friction / sliding;
  for (std::size_t axis = 0; axis < 3; ++axis) change[axis] = approach * normal[axis] - share * along[axis];
  return sticks ? Touch::sticks : Touch::slides;
}

void RigidContact::act(std::size_t tile, const TileNodes& nodes, std::span<Reaction> reactions) {
  Touch* touches = touches_.data() + tile * TileNodes::count;
  const std::uint8_t* held = held_->data() + tile * TileNodes::count;
  if (!may_touch(tile)) return;
  std::fill(touches, touches + TileNodes::count, Touch::none);
  Reaction& reaction = reactions[condition_];
  std::array<double, TileNodes::count> allowed;
  find_allowed(tile, nodes, allowed);
  const auto axes = static_cast<std::size_t>(frame_.dimensions);
  for (int node = 0; node < TileNodes::count; ++node) {
    Components normal, change;
    const double mass = nodes.mass()[node];
    if (!(mass > 0) || distance(nodes, node, normal) > on_surface_within * frame_.cell) continue;
    touches[node] = respond(relative_velocity(nodes, node), normal, allowed[static_cast<std::size_t>(node)],
                            held[node], change);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      double& a = nodes.acceleration(static_cast<int>(axis))[node];
      double& v = nodes.velocity(static_cast<int>(axis))[node];
      a += change[axis] / kick_;
      v += change[axis];
      // Force times the velocity in the middle of the kick is what the body gains.
      const double impulse = mass * change[axis];
      reaction.impulse[axis] += impulse;
      reaction.work += impulse * velocity_[axis];
      reaction.dissipated += impulse * (velocity_[axis] - (v - 0.5 * kick_ * a));
    }
  }
}

/// Friction has been applied once, with the momentum that was mapped first. What stuck sticks here too, and what
/// pressed does not part either. Half of it, as between bodies: forces have worked on the mean of the velocities
/// before and after contact, which is what strains must see for energy to be kept.
void RigidContact::act_on_mapped(std::size_t tile, const TileNodes& nodes) const {
  if (!may_touch(tile)) return;
  const auto axes = static_cast<std::size_t>(frame_.dimensions);
  for (int node = 0; node < TileNodes::count; ++node) {
    const std::size_t index = tile * TileNodes::count + static_cast<std::size_t>(node);
    Components normal, relative{};
    if (distance(nodes, node, normal) > on_surface_within * frame_.cell) continue;
    if (gaps_ && touches_[index] == Touch::none) continue;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      relative[axis] = nodes.mapped_velocity(static_cast<int>(axis))[node] - velocity_[axis];
      if ((*held_)[index] >> axis & 1u) relative[axis] = normal[axis] = 0;
    }
    const double square = dot(normal, normal);
    double share = square > least_normal * least_normal ? dot(relative, normal) / square : 0;
    if (obstacle_.separates && touches_[index] == Touch::none) share = std::min(share, 0.0);
    for (std::size_t axis = 0; axis < axes; ++axis)
      nodes.mapped_velocity(static_cast<int>(axis))[node] -=
          0.5 * (touches_[index] == Touch::sticks ? relative[axis] : share * normal[axis]);
  }
}

}  // namespace trajan
