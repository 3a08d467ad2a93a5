#include "solver/boundaries/absorbing_condition.h"

namespace trajan {

void AbsorbingCondition::make(const Model& model, std::vector<std::unique_ptr<SurfaceCondition>>& conditions) {
  for (std::size_t i = 0; i < model.conditions.size(); ++i)
    if (const auto* surface = std::get_if<AbsorbingSurface>(&model.conditions[i].kind))
      conditions.push_back(std::make_unique<AbsorbingCondition>(model, *surface, i));
}

AbsorbingCondition::AbsorbingCondition(const Model& model, const AbsorbingSurface& surface, std::size_t condition)
    : SurfaceCondition(model, condition, surface.points, surface.normal, false), surface_(surface) {}

Reaction AbsorbingCondition::act(Tiles& tiles, const HeldComponents& held) {
  Reaction reaction;
  for (int axis = 0; axis < axes_; ++axis) {
    const double impedance = surface_.impedance[static_cast<std::size_t>(axis)];
    for (const SurfaceMean& part : means_) {
      const Mean after = mean(tiles, held, part, node_velocity, axis);
      const Mean rate = mean(tiles, held, part, node_acceleration, axis);
      // Force -Z A times the velocity in the middle of the kick, which the impulse changes itself.
      const double dashpot = kick_ * impedance * part.area;
      const double middle = after.velocity - 0.5 * kick_ * rate.velocity;
      const double impulse = -dashpot * middle / (1 + 0.5 * dashpot * after.inverse_mass);
      const Pushed pushed = push(tiles, held, part, axis, impulse, kick_);
      reaction.dissipated -= pushed.work;
      reaction.impulse[static_cast<std::size_t>(axis)] += pushed.impulse;
    }
  }
  return reaction;
}

}  // namespace trajan
