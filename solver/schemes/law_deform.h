#pragma once

#include "solver/schemes/law_kernels.h"

/// How the state of a block's particles follows the motion.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// A finite law after its deformation gradient: what it remembers, and its stretches across plane or bar.
template <class Law, Dimension D>
TRAJAN_FLATTEN void settle(Block& block) {
  using Stages = LawStages<Law, D>;
  constexpr int N = Stages::N;
  const typename Stages::Particles particles(block);
  const Law material = Stages::law(block);
  const double dt = deformation_time(block);
  if constexpr (Stages::free_rest) {
    std::int64_t open = 1;
    for (int round = 0; open > 0 && round < most_corrections; ++round) {
      open = 0;
#pragma GCC ivdep
      for (int i = 0; i < block.count; ++i) {
        Tensor<N> f = particles.deformation.at(i);
        open += !correct_rest(material, particles.history.at(i), dt, f);
        unroll<3 - N>([&](auto k) { particles.deformation.diagonal[N + k][i] = f.diagonal[N + k]; });
      }
    }
    block.scratch->trouble.unsolved += open;
  }
  if constexpr (Stages::history_size > 0) {
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) {
      typename Stages::History history = particles.history.at(i);
      material.evolve(particles.deformation.at(i), dt, history);
      particles.history.set(i, history);
    }
  }
}

/// The displacement gradient of a step without what is across, or with what has been found of it.
template <Dimension D>
Tensor<grid_axes(D)> step_gradient(Scratch& scratch, double dt, int i) {
  constexpr int N = grid_axes(D);
  Tensor<N> g = dt * GradientArrays<D>{scratch}.at(i);
  if constexpr (rest_is_free(D)) unroll<3 - N>([&](auto k) { g.diagonal[N + k] = scratch.across[k][i]; });
  return g;
}

/// Finds the strains across that free a step of a rate law of the stress across.
template <class Law, Dimension D>
TRAJAN_FLATTEN void solve_across(Block& block) {
  using Stages = LawStages<Law, D>;
  constexpr int N = Stages::N;
  Scratch& scratch = *block.scratch;
  const typename Stages::Particles particles(block);
  const Law material = Stages::law(block);
  const double dt = deformation_time(block);
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    const Tensor<N> g = dt * GradientArrays<D>{scratch}.at(i);
    const double thinning = material.moduli(particles.state(i)).thinning(D) * trace(g);
    unroll<3 - N>([&](auto k) { scratch.across[k][i] = thinning; });
  }
  std::int64_t open = 1;
  for (int round = 0; open > 0 && round < most_corrections; ++round) {
    open = 0;
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) {
      Tensor<N> g = step_gradient<D>(scratch, dt, i);
      open += !correct_rest(material, particles.state(i), dt, g);
      unroll<3 - N>([&](auto k) { scratch.across[k][i] = g.diagonal[N + k]; });
    }
  }
  scratch.trouble.unsolved += open;
}

/// The damage of a rate law after a step, a part after the other. Each of them waits for its operands most of the
/// time, so that a processor is to see several particles' at once: with two divisions and a root less,
/// 27 -> 14 ns per particle and step, the elastic part included.
template <class Law, Dimension D>
TRAJAN_FLATTEN void grow_damage(Block& block) {
  using Stages = LawStages<Law, D>;
  const typename Stages::Particles particles(block);
  const Law material = Stages::law(block);
  GrowingDamage& s = block.scratch->damage;
  const auto for_particles = [&](auto&& part) __attribute__((always_inline)) {
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) part(i);
  };
  for_particles([&](int i) {
    const auto drive = material.drive(particles.state(i));
    s.value[i] = drive.ratio;
    s.stiffness[i] = drive.pores.stiffness;
    s.stored_share[i] = drive.pores.stored_share;
  });
  for_particles([&](int i) { s.value[i] = material.damage().log_hazard(s.value[i]); });
  for_particles([&](int i) { s.value[i] = material.damage().hazard(s.value[i]); });
  for_particles([&](int i) { s.value[i] = material.damage().failed(s.value[i]); });
  for_particles([&](int i) {
    typename Stages::State state = particles.state(i);
    material.grow(s.value[i], {0.0, {s.stiffness[i], s.stored_share[i]}}, state);
    particles.history.set(i, state.history);
  });
}

/// Stress, volume and history of a rate law by a step.
template <class Law, Dimension D>
TRAJAN_FLATTEN void advance(Block& block) {
  using Stages = LawStages<Law, D>;
  using State = typename Stages::State;
  constexpr int N = Stages::N;
  constexpr bool relaxes = requires(const Law& l, Tensor<N>& g, const State& s) { l.relax(g, s); };
  if constexpr (Stages::free_rest && !relaxes) solve_across<Law, D>(block);
  Scratch& scratch = *block.scratch;
  const typename Stages::Particles particles(block);
  const Law material = Stages::law(block);
  const double dt = deformation_time(block);
  std::int64_t inverted = 0;
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    State state = particles.state(i);
    Tensor<N> g;
    if constexpr (relaxes) {
      g = dt * GradientArrays<D>{scratch}.at(i);
      if constexpr (Stages::free_rest) material.relax(g, state);
    } else {
      g = step_gradient<D>(scratch, dt, i);
    }
    advance_undamaged(material, g, dt, state);
    particles.stress.set(i, state.stress);
    particles.volume[i] = state.volume_ratio * particles.reference_volume(i);
    if constexpr (!is_damaged<Law>()) particles.history.set(i, state.history);
    inverted += !(state.volume_ratio > 0);
  }
  scratch.trouble.inverted += inverted;
  if constexpr (is_damaged<Law>()) grow_damage<Law, D>(block);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
