#include "solver/implicit/responses.h"

#include <atomic>

#include "solver/schemes/scheme.h"

namespace trajan {

Responses::Responses(const Model& model, Executor& executor) : executor_(executor) {
  const bool total = is_total_lagrangian(model.numerics.scheme);
  for (const Body& body : model.bodies)
    laws_.push_back(law_response(model.materials[body.material].kind->name, model.dimension, total));
  if (model.numerics.locking_remedy == "mean_dilatation")
    mean_dilatation_ = std::make_unique<MeanDilatation>(model, executor);
}

const std::vector<double>& Responses::feel(const Discretization& on, std::span<const double> displacement) {
  gradients_.resize(on.particles() * static_cast<std::size_t>(on.components()));
  executor_.visit([&](Block& block, std::size_t b, std::size_t) {
    find_gradients(on, displacement, on.first_particle(b), block.count);
  });
  return mean_dilatation_ ? mean_dilatation_->felt(on, gradients_) : gradients_;
}

/// G = sum of displacements times gradients; the hoop is the radial displacement over the radius.
void Responses::find_gradients(const Discretization& on, std::span<const double> displacement, std::size_t first,
                               int count) {
  const auto axes = static_cast<std::size_t>(on.axes()), n = static_cast<std::size_t>(on.components());
  for (std::size_t p = first; p < first + static_cast<std::size_t>(count); ++p) {
    const Discretization::Particle particle = on.particle(p);
    double* gradient = &gradients_[p * n];
    std::fill(gradient, gradient + n, 0.0);
    for (std::size_t k = 0; k < particle.nodes.size(); ++k) {
      const double* u = &displacement[particle.nodes[k] * axes];
      const double* slope = particle.gradients + k * axes;
      for (std::size_t i = 0; i < axes; ++i)
        for (std::size_t j = 0; j < axes; ++j) gradient[i * axes + j] += u[i] * slope[j];
      if (on.axisymmetric()) gradient[axes * axes] += u[0] * particle.weights[k] * particle.inverse_radius;
    }
  }
}

Responses::Trouble Responses::evaluate(const Discretization& on, std::span<const double> displacement, double dt,
                                       bool with_tangents) {
  const auto n = static_cast<std::size_t>(on.components());
  const std::vector<double>& felt = feel(on, displacement);
  with_tangents = with_tangents || mean_dilatation_;
  forces_.resize(on.particles() * n);
  if (with_tangents) tangents_.resize(on.particles() * n * n);
  std::vector<std::atomic<std::int64_t>> inverted(laws_.size()), unsolved(laws_.size());
  executor_.visit([&](Block& block, std::size_t b, std::size_t) {
    const std::size_t first = on.first_particle(b);
    LawResponse response;
    response.gradient = &felt[first * n];
    response.force = &forces_[first * n];
    response.tangent = with_tangents ? &tangents_[first * n * n] : nullptr;
    const std::size_t body = executor_.tiles().blocks()[b].body;
    laws_[body]->respond(block, dt, response);
    inverted[body] += response.inverted;
    unsolved[body] += response.unsolved;
  });
  Trouble trouble;
  for (std::size_t body = laws_.size(); body-- > 0;) {
    trouble.inverted += inverted[body];
    trouble.unsolved += unsolved[body];
    if (inverted[body] + unsolved[body] > 0) trouble.body = static_cast<std::int64_t>(body);
  }
  if (mean_dilatation_ && trouble.none()) mean_dilatation_->pull(on, forces_, tangents_);
  return trouble;
}

void Responses::commit(const Discretization& on, std::span<const double> displacement, double dt) {
  const auto n = static_cast<std::size_t>(on.components()), grid = n - (on.axisymmetric() ? 1 : 0);
  const std::vector<double>& felt = feel(on, displacement);
  executor_.visit([&](Block& block, std::size_t b, std::size_t) {
    const std::size_t first = on.first_particle(b);
    const std::uint16_t body = executor_.tiles().blocks()[b].body;
    laws_[body]->commit(block, dt, &felt[first * n]);
    const LawKernels& law = *executor_.bodies()[body].law;
    if (law.track == nullptr || block[Attribute::deformation_xx] == nullptr) return;
    // The law does without a deformation gradient, somebody else does not: it follows "velocities" for a unit
    // time.
    SweepConstants unit = *block.sweep;
    unit.drift = 1;
    block.sweep = &unit;
    for (int i = 0; i < block.count; ++i) {
      const double* gradient = &gradients_[(first + static_cast<std::size_t>(i)) * n];
      for (std::size_t c = 0; c < grid; ++c) block.scratch->gradient[c][i] = gradient[c];
      if (on.axisymmetric()) block.scratch->gradient_rest[i] = gradient[grid];
    }
    law.track(block);
  });
  if (mean_dilatation_) mean_dilatation_->commit(on);
}

}  // namespace trajan
