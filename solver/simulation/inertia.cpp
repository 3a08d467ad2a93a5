#include <algorithm>

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

void Executor::halt() {
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
