#pragma once

#include <vector>

#include "solver/model/model.h"

namespace trajan {

struct BodyParticles;

/// Accelerations by formulas of place and time. They are evaluated particle by particle before a pass over
/// blocks begins, so that the pass reads numbers only.
class BodyFields {
 public:
  explicit BodyFields(const Model& model);
  /// Whether particles of this body are accelerated one by one.
  static bool act_on(const Model& model, std::size_t body);
  /// Whether any of them is evaluated where particles are at the present.
  bool follow_particles() const;
  /// Sets the particles' own accelerations of this time.
  void evaluate(std::vector<BodyParticles>& bodies, double time) const;

 private:
  void add(const BodyLoad& load, std::size_t index, BodyParticles& body, double time) const;

  const Model& model_;
  bool total_lagrangian_;
  std::vector<std::vector<Vector>> references_;  ///< by body and number; empty: not needed
};

}  // namespace trajan
