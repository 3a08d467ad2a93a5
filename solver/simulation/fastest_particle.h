#pragma once

#include <algorithm>
#include <iterator>
#include <string>

#include "solver/model/names.h"
#include "solver/simulation/executor.h"

namespace trajan {

/// Where to look first when a motion as a whole goes wrong.
inline Slot fastest_particle(const Executor& executor, int axes) {
  Slot fastest;
  double largest = -1;
  for (std::uint32_t b = 0; b < executor.bodies().size(); ++b) {
    const BodyParticles& body = executor.bodies()[b];
    for (std::uint32_t i = 0; i < body.size(); ++i) {
      double square = 0;
      for (int axis = 0; axis < axes; ++axis) {
        const double v = body.value(Attribute::velocity_x, axis, i);
        square += v * v;
      }
      if (square > largest) largest = square, fastest = {b, i};
    }
  }
  return fastest;
}

/// Of a particle among those of all bodies, as outputs count them.
inline std::int64_t particle_number(const Model& model, const Executor& executor, const Slot& particle) {
  return model.bodies[particle.body].first_particle + executor.bodies()[particle.body].number[particle.index];
}

/// 'a particle of body "beam"', by the particle's number among all.
inline std::string particle_text(const Model& model, std::int64_t number) {
  const auto after = std::ranges::upper_bound(model.bodies, number, {}, &Body::first_particle);
  return "a particle of body " + quoted(std::prev(after)->name);
}

}  // namespace trajan
