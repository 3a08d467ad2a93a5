#include "solver/implicit/mean_dilatation.h"

#include "solver/schemes/law_response.h"
#include "solver/schemes/law_state.h"
#include "solver/schemes/scheme.h"

namespace trajan {

MeanDilatation::MeanDilatation(const Model& model, Executor& executor)
    : model_(model), executor_(executor), total_lagrangian_(is_total_lagrangian(model.numerics.scheme)) {}

/// A finite law in a total Lagrangian analysis stores the gradient that it feels; the particle's volume tells the
/// gradient that it has.
template <Dimension D>
void MeanDilatation::read_state(Block& block, std::size_t first, const Body& body) {
  using Sharing = VolumeSharing<D>;
  constexpr int n = Sharing::components;
  const MaterialKind& kind = *model_.materials[body.material].kind;
  const bool linear = law_response(kind.name, D, total_lagrangian_)->geometrically_linear;
  const DeformationArrays<Sharing::N, D == Dimension::axisymmetric> deformation(block);
  const double* volumes = block[Attribute::volume];
  for (int i = 0; i < block.count; ++i) {
    const std::size_t p = first + static_cast<std::size_t>(i);
    const double at_rest = block.mass(i) / block.body->density;
    Particle& particle = particles_[p] = {linear, 1, at_rest, 1};
    Tensor<Sharing::N> stored = identity<Sharing::N>(), start = stored;
    if (total_lagrangian_) stored = start = deformation.at(i);
    if (kind.rate_form) {
      particle.weight = volumes[i];
      particle.factor = 1 / determinant(start);
    } else if (total_lagrangian_) {
      start = Sharing{linear, 1}.felt(stored, volumes[i] / at_rest);
    } else {
      particle.weight *= determinant(deformation.at(i));
    }
    Sharing::write(stored, &stored_[p * n]);
    Sharing::write(start, &start_[p * n]);
  }
}

/// Volume ratios of the particles, then of the cell, then what laws feel.
template <Dimension D>
void MeanDilatation::share(const Discretization& on, std::size_t c, const std::vector<double>& gradients) {
  using Sharing = VolumeSharing<D>;
  constexpr std::size_t n = Sharing::components;
  const auto rest = identity<Sharing::N>();
  Shared& shared = shared_[c] = {};
  const auto members = on.members(c);
  for (std::uint32_t p : members) {
    for (std::size_t i = p * n; i < (p + 1) * n; ++i) end_[i] = start_[i] + gradients[i];
    Particle& particle = particles_[p];
    particle.ratio = Sharing{particle.linear, particle.factor}.ratio(Sharing::read(&end_[p * n], rest));
    shared.weight += particle.weight;
    shared.ratio += particle.weight * particle.ratio;
  }
  shared.ratio /= shared.weight;
  for (std::uint32_t p : members) {
    const Particle& particle = particles_[p];
    Tensor<Sharing::N> h = Sharing::read(&end_[p * n], rest);
    // What is turned inside out is left to the law to be found.
    if (particle.ratio > 0 && shared.ratio > 0)
      h = Sharing{particle.linear, particle.factor}.felt(h, shared.ratio);
    Sharing::write(h, &felt_[p * n]);
    for (std::size_t i = p * n; i < (p + 1) * n; ++i) felt_[i] -= stored_[i];
  }
}

const std::vector<double>& MeanDilatation::felt(const Discretization& on, const std::vector<double>& gradients) {
  particles_.resize(on.particles());
  shared_.resize(on.cells());
  for (std::vector<double>* values : {&start_, &stored_, &end_, &felt_}) values->resize(gradients.size());
  executor_.visit([&](Block& block, std::size_t b, std::size_t) {
    in_volume_dimension(model_.dimension, [&]<Dimension D>() {
      read_state<D>(block, on.first_particle(b), model_.bodies[executor_.tiles().blocks()[b].body]);
    });
  });
  for_each_cell(on, [&]<Dimension D>(std::size_t c) { share<D>(on, c, gradients); });
  return felt_;
}

void MeanDilatation::commit(const Discretization& on) {
  if (!total_lagrangian_) return;
  executor_.visit([&](Block& block, std::size_t b, std::size_t) {
    const Body& body = model_.bodies[executor_.tiles().blocks()[b].body];
    const bool rate_form = model_.materials[body.material].kind->rate_form;
    for (int i = 0; i < block.count; ++i) {
      const std::size_t p = on.first_particle(b) + static_cast<std::size_t>(i);
      if (!rate_form) {
        block[Attribute::volume][i] = block.mass(i) / block.body->density * particles_[p].ratio;
        continue;
      }
      in_volume_dimension(model_.dimension, [&]<Dimension D>() {
        using Sharing = VolumeSharing<D>;
        DeformationArrays<Sharing::N, D == Dimension::axisymmetric>(block).set(
            i, Sharing::read(&end_[p * Sharing::components], identity<Sharing::N>()));
      });
    }
  });
}

}  // namespace trajan
