#include "solver/simulation/angular_momentum.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "solver/model/names.h"
#include "solver/schemes/scheme.h"
#include "solver/simulation/fastest_particle.h"
#include "solver/simulation/particle_fields.h"

namespace trajan {
namespace {

/// Velocities that are off by this much are doubtful.
constexpr double least_error = 0.03;

using Vector3 = AngularMomentum::Vector3;

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void add(Vector3& sum, const Vector3& term) {
  for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += term[axis];
}

/// Whether no torque about the centre of mass of all bodies comes from outside, and the solver owes it that.
bool is_free(const Model& model) {
  const bool turns = grid_axes(model.dimension) > 1 && model.dimension != Dimension::axisymmetric;
  const bool moves = std::holds_alternative<ExplicitDynamics>(model.analysis) ||
                     std::holds_alternative<ImplicitDynamics>(model.analysis);
  const auto pulls_evenly = [&](const BodyLoad& load) {
    return load.bodies.size() == model.bodies.size() &&
           std::ranges::none_of(load.field, [](const auto& component) { return component.has_value(); });
  };
  return turns && moves && model.conditions.empty() && model.surface_loads.empty() && model.damping == 0 &&
         std::ranges::all_of(model.body_loads, pulls_evenly) &&
         std::ranges::none_of(model.grid.periodic, std::identity{});
}

/// Of one body: about its own centre of mass, but for that and the momentum itself.
struct BodyMotion {
  double mass = 0, inertia = 0;
  Vector3 centre{}, momentum{}, angular{};
};

BodyMotion motion_of(const BodyParticles& body, int axes, bool moves_from_place) {
  BodyMotion motion;
  if (body.size() == 0) return motion;
  const std::vector<double>& volumes = body[Attribute::reference_volume];
  // Places from that of a particle: far from the origin their squares would cancel.
  Vector3 from{}, offset{};
  for (std::size_t i = 0; i < body.size(); ++i) {
    const double mass = volumes.empty() ? body.constants.mass : body.constants.density * volumes[i];
    Vector3 at{}, momentum{};
    for (int axis = 0; axis < axes; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      at[a] = body.component(Attribute::position_x, axis)[i];
      if (moves_from_place) at[a] += body.component(Attribute::displacement_x, axis)[i];
      if (i == 0) from[a] = at[a];
      at[a] -= from[a];
      momentum[a] = mass * body.value(Attribute::velocity_x, axis, i);
      offset[a] += mass * at[a];
      motion.momentum[a] += momentum[a];
      motion.inertia += mass * at[a] * at[a];
    }
    motion.mass += mass;
    add(motion.angular, cross(at, momentum));
  }
  for (std::size_t a = 0; a < 3; ++a) {
    motion.inertia -= offset[a] * offset[a] / motion.mass;
    offset[a] /= motion.mass;
    motion.centre[a] = from[a] + offset[a];
  }
  add(motion.angular, cross(motion.momentum, offset));
  return motion;
}

std::string remedy(const Model& model) {
  if (std::holds_alternative<ImplicitDynamics>(model.analysis)) return "take smaller cells";
  const bool total = is_total_lagrangian(model.numerics.scheme);
  const std::string other = total ? "smaller cells" : "numerics.scheme: \"TLMPM\", which errs less";
  Numerics affine = model.numerics;
  affine.transfer = "APIC";
  const bool fits = find_transfer(affine.transfer)->objection(affine).empty();
  return (fits ? "choose numerics.transfer: \"APIC\", which keeps it, or " : "take ") + other;
}

}  // namespace

AngularMomentum::AngularMomentum(const Model& model, const Executor& executor)
    : model_(model),
      executor_(executor),
      watched_(is_free(model) && !find_transfer(model.numerics.transfer)->affine) {}

AngularMomentum::Moments AngularMomentum::moments() const {
  const bool total = is_total_lagrangian(model_.numerics.scheme);
  std::vector<BodyMotion> bodies;
  for (const BodyParticles& body : executor_.bodies())
    bodies.push_back(motion_of(body, grid_axes(model_.dimension), total));
  Moments all;
  Vector3 centre{};
  double mass = 0;
  for (const BodyMotion& body : bodies) {
    mass += body.mass;
    for (std::size_t a = 0; a < 3; ++a) centre[a] += body.mass * body.centre[a];
  }
  for (const BodyMotion& body : bodies) {
    Vector3 from_centre{};
    for (std::size_t a = 0; a < 3; ++a) from_centre[a] = body.centre[a] - centre[a] / mass;
    add(all.momentum, body.angular);
    add(all.momentum, cross(from_centre, body.momentum));
    all.inertia += body.inertia;
  }
  return all;
}

std::optional<Warning> AngularMomentum::check(std::int64_t step, double time, double internal_energy) {
  if (!watched_) return std::nullopt;
  const Moments now = moments();
  if (step == 0) initial_ = now.momentum;
  largest_energy_ = std::max(largest_energy_, internal_energy);
  double square = 0;
  for (std::size_t a = 0; a < 3; ++a) square += std::pow(now.momentum[a] - initial_[a], 2);
  // Velocities that are off by w, sum m r x w = L, have sum m w^2 >= L^2 / sum m r^2 (Cauchy and Schwarz). Linear
  // momentum is kept, so that r may be from each body's own centre. Single particles cannot spin.
  const double error = std::sqrt(square / (now.inertia * 2 * largest_energy_));
  if (!(now.inertia > 0 && error > least_error)) return std::nullopt;
  watched_ = false;
  const Slot fastest = fastest_particle(executor_, grid_axes(model_.dimension));
  Warning warning;
  warning.name = "angular momentum";
  warning.step = step;
  warning.time = time;
  warning.particle = particle_number(model_, executor_, fastest);
  warning.place = ParticleFields(model_, executor_).position(fastest);
  warning.cause = "angular momentum has changed by " + std::to_string(error) +
                  " times what can spin with the energy in strains and relative motion, though nothing outside "
                  "exerts a torque: lumped masses do not keep it";
  warning.remedy = remedy(model_);
  return warning;
}

}  // namespace trajan
