#pragma once

#include <array>

#include "solver/simulation/executor.h"

namespace trajan {

/// Most components that a field has.
inline constexpr std::size_t most_components = 9;

/// What fields are at a particle, while particles may be looked at.
class ParticleFields {
 public:
  ParticleFields(const Model& model, const Executor& executor);

  Vector position(const Slot& particle) const;
  /// What a field's values are weighted by in a mean.
  double reference_volume(const Slot& particle) const;
  /// The first field.width() of `out` in the order of field.components; not a number if the particle has no
  /// such field. `reference` is its position at time 0.
  void read(const RecordedField& field, const Slot& particle, Vector reference,
            std::span<double, most_components> out) const;

 private:
  using Matrix = std::array<std::array<double, 3>, 3>;
  double velocity(const Slot& particle, int axis) const;
  /// xx, yy, zz, xy, yz, xz
  std::array<double, 6> stress(const Slot& particle) const;
  Matrix deformation_gradient(const Slot& particle) const;

  const Model& model_;
  const Executor& executor_;
  bool total_lagrangian_;
};

}  // namespace trajan
