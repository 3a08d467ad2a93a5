#include <algorithm>

#include "solver/schemes/scheme.h"
#include "solver/simulation/executor.h"

/// Inertia and motion as mere means to find a state of rest.
namespace trajan {

void Executor::scale_inertia(std::size_t index, double factor) {
  BodyParticles& body = bodies_[index];
  body.inertia *= factor;
  body.constants.density *= factor;
  body.constants.mass *= factor;
  lightest_particle_ = lightest_particle(bodies_);
}

/// What rides on particles, loads and conditions, stays where it is.
void Executor::halt(double drift) {
  if (drift > 0) {
    const bool total_lagrangian = is_total_lagrangian(model_.numerics.scheme);
    const Attribute place = total_lagrangian ? Attribute::displacement_x : Attribute::position_x;
    const Pass passes[] = {Pass::locate, Pass::gather_velocity, total_lagrangian ? Pass::displace : Pass::move};
    sweep_.drift = drift;
    run(passes);
    for (BodyParticles& body : bodies_)
      for (int axis = 0; axis < axes_; ++axis) {
        const std::span<double> x = body.component(place, axis);
        for (std::uint32_t i = 0; i < body.size(); ++i) x[i] -= drift * body.value(Attribute::velocity_x, axis, i);
      }
  }
  account_.add(0, totals().kinetic_energy);
  for (BodyParticles& body : bodies_) {
    const auto forget = [&body](Attribute first, int components) {
      for (int c = 0; c < components; ++c) {
        std::ranges::fill(body.component(first, c), 0.0);
        std::ranges::fill(body.floats[static_cast<int>(first) + c], 0.0F);
      }
    };
    forget(Attribute::velocity_x, axes_);
    forget(Attribute::affine_xx, 9);
  }
}

}  // namespace trajan
