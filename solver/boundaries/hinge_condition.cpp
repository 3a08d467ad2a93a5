#include "solver/boundaries/hinge_condition.h"

namespace trajan {

void HingeCondition::make(const Model& model, std::vector<std::unique_ptr<SurfaceCondition>>& conditions) {
  for (std::size_t i = 0; i < model.conditions.size(); ++i)
    if (const auto* surface = std::get_if<HeldSurface>(&model.conditions[i].kind))
      conditions.push_back(std::make_unique<HingeCondition>(model, *surface, i));
}

HingeCondition::HingeCondition(const Model& model, const HeldSurface& surface, std::size_t condition)
    : SurfaceCondition(model, condition, surface.points, surface.normal, surface.mean),
      surface_(surface),
      velocities_(model) {}

void HingeCondition::prepare(const Kick& kick) {
  kick_ = kick.length();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::optional<Formula>& u = surface_.displacement[axis];
    if (!u) continue;
    velocity_[axis] = velocities_.of(*u, true, {}, kick);
    moved_[axis] = (*u)({}, kick.time + kick.drift);
  }
}

Reaction HingeCondition::act(Tiles& tiles, const HeldComponents& held) {
  Reaction reaction;
  for (int axis = 0; axis < axes_; ++axis) {
    if (!surface_.held[static_cast<std::size_t>(axis)]) continue;
    const PrescribedVelocities::Value& wanted = velocity_[static_cast<std::size_t>(axis)];
    for (const SurfaceMean& part : means_) {
      give(tiles, held, part, node_velocity, axis, wanted.after);
      const double force = give(tiles, held, part, node_acceleration, axis, wanted.acceleration);
      const Pushed pushed = account(tiles, held, part, axis, kick_ * force, kick_);
      reaction.work += pushed.work;
      reaction.impulse[static_cast<std::size_t>(axis)] += pushed.impulse;
    }
  }
  return reaction;
}

void HingeCondition::act_on_mapped(Tiles& tiles, const HeldComponents& held) const {
  for (int axis = 0; axis < axes_; ++axis) {
    if (!surface_.held[static_cast<std::size_t>(axis)]) continue;
    for (const SurfaceMean& part : means_)
      give(tiles, held, part, node_mapped_velocity, axis, velocity_[static_cast<std::size_t>(axis)].after);
  }
}

/// Where every point is held, it is known where it is.
void HingeCondition::advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift) {
  SurfaceCondition::advect(tiles, bodies, drift);
  if (riders_.total_lagrangian() || surface_.mean || !(drift > 0)) return;
  for (std::size_t p = 0; p < riders_.size(); ++p)
    for (int axis = 0; axis < axes_; ++axis)
      if (surface_.held[static_cast<std::size_t>(axis)])
        riders_.place(p, axis,
                      component(riders_.point(p).position, axis) + moved_[static_cast<std::size_t>(axis)]);
}

void HingeCondition::constrain(double from, double to, MeanConstraints& constraints) const {
  for (int axis = 0; axis < axes_; ++axis) {
    if (!surface_.held[static_cast<std::size_t>(axis)]) continue;
    const std::optional<Formula>& u = surface_.displacement[static_cast<std::size_t>(axis)];
    const double displacement = u ? (*u)({}, to) - (*u)({}, from) : 0;
    for (const SurfaceMean& part : means_)
      constraints.prescribe_mean(condition(), nodes_of(part), axis, displacement);
  }
}

}  // namespace trajan
