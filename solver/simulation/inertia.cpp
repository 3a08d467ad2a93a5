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
    for (int axis = 0; axis < axes_; ++axis) std::ranges::fill(body.component(Attribute::velocity_x, axis), 0.0);
    for (int c = 0; c < 9; ++c) std::ranges::fill(body.component(Attribute::affine_xx, c), 0.0);
  }
}

}  // namespace trajan
