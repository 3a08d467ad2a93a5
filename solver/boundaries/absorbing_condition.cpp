#include "solver/boundaries/absorbing_condition.h"

namespace trajan {

void AbsorbingCondition::make(const Model& model, std::vector<std::unique_ptr<SurfaceCondition>>& conditions) {
  for (const BoundaryCondition& condition : model.conditions)
    if (const auto* surface = std::get_if<AbsorbingSurface>(&condition.kind))
      conditions.push_back(std::make_unique<AbsorbingCondition>(model, *surface));
}

AbsorbingCondition::AbsorbingCondition(const Model& model, const AbsorbingSurface& surface)
    : SurfaceCondition(model, surface.points, surface.normal, false), surface_(surface) {}

Reaction AbsorbingCondition::act(Tiles& tiles, const HeldComponents& held) {
  Reaction reaction;
  for (int axis = 0; axis < axes_; ++axis) {
    const double impedance = axis == surface_.normal ? surface_.normal_impedance : surface_.shear_impedance;
    for (const SurfaceMean& part : means_) {
      const Mean after = mean(tiles, held, part, node_velocity, axis);
      const Mean rate = mean(tiles, held, part, node_acceleration, axis);
      // Force -Z A times the velocity in the middle of the kick, which the impulse changes itself.
      const double dashpot = kick_ * impedance * part.area;
      const double middle = after.velocity - 0.5 * kick_ * rate.velocity;
      const double impulse = -dashpot * middle / (1 + 0.5 * dashpot * after.inverse_mass);
      reaction.dissipated -= impulse * push(tiles, held, part, axis, impulse, kick_);
    }
  }
  return reaction;
}

}  // namespace trajan
