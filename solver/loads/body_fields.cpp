#include "solver/loads/body_fields.h"

#include <algorithm>

#include "solver/schemes/scheme.h"
#include "solver/simulation/particles.h"

namespace trajan {

namespace {

bool is_field(const BodyLoad& load) {
  return std::ranges::any_of(load.field, [](const auto& component) { return component.has_value(); });
}

bool acts_on(const BodyLoad& load, std::size_t body) {
  return is_field(load) && std::ranges::find(load.bodies, body) != load.bodies.end();
}

Vector place_of(const BodyParticles& body, std::size_t slot, int axes, bool displaced) {
  double place[3] = {0, 0, 0};
  for (int axis = 0; axis < axes; ++axis) {
    place[axis] = body.component(Attribute::position_x, axis)[slot];
    if (displaced) place[axis] += body.component(Attribute::displacement_x, axis)[slot];
  }
  return {place[0], place[1], place[2]};
}

}  // namespace

BodyFields::BodyFields(const Model& model)
    : model_(model),
      total_lagrangian_(is_total_lagrangian(model.numerics.scheme)),
      references_(model.bodies.size()) {
  // Particles of total Lagrangian schemes carry their reference positions.
  for (std::size_t b = 0; b < model.bodies.size() && !total_lagrangian_; ++b) {
    const bool needed = std::ranges::any_of(
        model.body_loads, [b](const BodyLoad& load) { return load.reference && acts_on(load, b); });
    if (!needed) continue;
    references_[b].reserve(static_cast<std::size_t>(model.bodies[b].particles));
    model.bodies[b].lattice.for_each_point([&](std::int64_t, Vector at) { references_[b].push_back(at); });
  }
}

bool BodyFields::act_on(const Model& model, std::size_t body) {
  return std::ranges::any_of(model.body_loads, [body](const BodyLoad& load) { return acts_on(load, body); });
}

bool BodyFields::follow_particles() const {
  return std::ranges::any_of(model_.body_loads,
                             [](const BodyLoad& load) { return is_field(load) && !load.reference; });
}

void BodyFields::evaluate(std::vector<BodyParticles>& bodies, double time) const {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!act_on(model_, b)) continue;
    for (int axis = 0; axis < grid_axes(model_.dimension); ++axis)
      std::ranges::fill(bodies[b].component(Attribute::load_x, axis), 0.0);
    for (const BodyLoad& load : model_.body_loads)
      if (acts_on(load, b)) add(load, b, bodies[b], time);
  }
}

void BodyFields::add(const BodyLoad& load, std::size_t index, BodyParticles& body, double time) const {
  const int axes = grid_axes(model_.dimension);
  const double factor = load.time(time) / body.inertia;
  const std::vector<Vector>& references = references_[index];
  for (std::size_t slot = 0; slot < body.size(); ++slot) {
    const Vector place = load.reference && !total_lagrangian_
                             ? references[body.number[slot]]
                             : place_of(body, slot, axes, total_lagrangian_ && !load.reference);
    for (int axis = 0; axis < axes; ++axis) {
      const auto& component = load.field[static_cast<std::size_t>(axis)];
      if (component) body.component(Attribute::load_x, axis)[slot] += factor * (*component)(place, time);
    }
  }
}

}  // namespace trajan
