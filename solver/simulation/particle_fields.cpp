#include "solver/simulation/particle_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/materials/dimension.h"
#include "solver/schemes/schemes.h"

namespace trajan {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Attribute after(Attribute first, int steps) { return static_cast<Attribute>(static_cast<int>(first) + steps); }

/// "yz" → 1, 2
std::array<std::size_t, 2> indices(std::string_view component) {
  return {static_cast<std::size_t>(component[0] - 'x'), static_cast<std::size_t>(component[1] - 'x')};
}

double von_mises(const std::array<double, 6>& s) {
  const auto square = [](double value) { return value * value; };
  return std::sqrt((square(s[0] - s[1]) + square(s[1] - s[2]) + square(s[2] - s[0])) / 2 +
                   3 * (square(s[3]) + square(s[4]) + square(s[5])));
}

}  // namespace

ParticleFields::ParticleFields(const Model& model, const Executor& executor)
    : model_(model),
      executor_(executor),
      total_lagrangian_(find_scheme(model.numerics.scheme)->total_lagrangian) {}

Vector ParticleFields::position(const Slot& particle) const {
  const BodyParticles& body = executor_.bodies()[particle.body];
  Vector at;
  double* const components[] = {&at.x, &at.y, &at.z};
  for (int axis = 0; axis < grid_axes(model_.dimension); ++axis) {
    *components[axis] = body.component(Attribute::position_x, axis)[particle.index];
    if (total_lagrangian_) *components[axis] += body.component(Attribute::displacement_x, axis)[particle.index];
  }
  return at;
}

double ParticleFields::reference_volume(const Slot& particle) const {
  const BodyParticles& body = executor_.bodies()[particle.body];
  const std::vector<double>& volumes = body[Attribute::reference_volume];
  return volumes.empty() ? body.constants.reference_volume : volumes[particle.index];
}

double ParticleFields::velocity(const Slot& particle, int axis) const {
  return executor_.bodies()[particle.body].value(Attribute::velocity_x, axis, particle.index);
}

std::array<double, 6> ParticleFields::stress(const Slot& particle) const {
  std::array<double, 6> recorded{}, stress{};
  executor_.stress(particle, recorded.data());
  const auto components = field_components(Field::stress, model_.dimension);
  const auto all = field_components(Field::stress, Dimension::solid);
  for (std::size_t c = 0; c < components.size(); ++c)
    stress[static_cast<std::size_t>(std::ranges::find(all, components[c]) - all.begin())] = recorded[c];
  return stress;
}

ParticleFields::Matrix ParticleFields::deformation_gradient(const Slot& particle) const {
  const BodyParticles& body = executor_.bodies()[particle.body];
  Matrix f{};
  const int axes = grid_axes(model_.dimension);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Attribute component = after(Attribute::deformation_xx, 3 * i + j);
      f[i][j] = body.has(component) ? body.value(component, particle.index) : i != j ? 0 : i < axes ? none : 1;
    }
  }
  // Where the stretch across is free and not stored, the volume tells it; a bar's two are taken as equal.
  const std::vector<double>& volume = body[Attribute::volume];
  if (!rest_is_free(model_.dimension) || body.has(Attribute::deformation_zz) || volume.empty()) return f;
  const double ratio = volume[particle.index] / reference_volume(particle);
  if (axes == 1)
    f[1][1] = f[2][2] = std::sqrt(ratio / f[0][0]);
  else
    f[2][2] = ratio / (f[0][0] * f[1][1] - f[0][1] * f[1][0]);
  return f;
}

void ParticleFields::read(const RecordedField& field, const Slot& particle, Vector reference,
                          std::span<double, most_components> out) const {
  const int axes = grid_axes(model_.dimension);
  const auto put_vector = [&](Vector v) {
    const double components[] = {v.x, v.y, v.z};
    std::copy_n(components, axes, out.begin());
  };
  switch (field.field) {
    case Field::position:
      return put_vector(position(particle));
    case Field::displacement: {
      const Vector at = position(particle);
      return put_vector({at.x - reference.x, at.y - reference.y, at.z - reference.z});
    }
    case Field::velocity:
      for (int axis = 0; axis < axes; ++axis) out[axis] = velocity(particle, axis);
      return;
    case Field::stress:
      return executor_.stress(particle, out.data());
    case Field::pressure: {
      const auto s = stress(particle);
      out[0] = -(s[0] + s[1] + s[2]) / 3;
      return;
    }
    case Field::von_mises_stress:
      out[0] = von_mises(stress(particle));
      return;
    case Field::deformation_gradient:
    case Field::strain: {
      const Matrix f = deformation_gradient(particle);
      for (std::size_t c = 0; c < field.components.size(); ++c) {
        const auto [i, j] = indices(field.components[c]);
        out[c] = f[i][j];
        if (field.field == Field::deformation_gradient) continue;
        out[c] = (f[0][i] * f[0][j] + f[1][i] * f[1][j] + f[2][i] * f[2][j] - (i == j ? 1 : 0)) / 2;
      }
      return;
    }
    case Field::history: {
      const int place = field.history[particle.body];
      const BodyParticles& body = executor_.bodies()[particle.body];
      out[0] = place < 0 ? none : body.value(after(Attribute::history_0, place), particle.index);
      return;
    }
    case Field::unspecified:
      break;
  }
}

}  // namespace trajan
