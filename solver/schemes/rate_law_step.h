#pragma once

#include "solver/schemes/step_kinematics.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <class Law, Dimension D, bool TotalLagrangian>
class RateLawStep {
 public:
  static constexpr int N = grid_axes(D), history_size = history_count<Law>();
  using Particles = LawParticles<Law, D, true>;

  RateLawStep(const Law& law, const Particles& particles, int i, double dt)
      : law_(law), motion_{identity<N>()}, state_(particles.state(i)), dt_(dt) {
    if constexpr (TotalLagrangian) motion_.start = particles.deformation.at(i);
  }

  /// Finds the rest of `g`; false: there is none.
  bool free_rest(Tensor<N>& g) const {
    Tensor<N> step = current(g);
    const double thinning = law_.moduli(state_).thinning(D) * trace(step);
    unroll<3 - N>([&](auto k) { step.diagonal[N + k] = thinning; });
    bool solved = false;
    for (int round = 0; !solved && round < most_corrections; ++round)
      solved = correct_rest(law_, state_, dt_, step);
    // Nothing has been stretched across plane or bar: F does not tell.
    unroll<3 - N>([&](auto k) { g.diagonal[N + k] = step.diagonal[N + k]; });
    return solved;
  }
  double volume_ratio(const Tensor<N>& g) const {
    return state_.volume_ratio * determinant(plus_diagonal(current(g), 1.0));
  }

  /// At the end.
  template <class T>
  SymmetricTensor<N, T> kirchhoff(const Tensor<N, T>& g) const {
    const RateState<N, T, history_size> end = state_after(g);
    return end.volume_ratio * cauchy_stress(law_, end);
  }
  template <class T>
  Tensor<N, T> nominal(const SymmetricTensor<N, T>& kirchhoff, const Tensor<N, T>& g) const {
    return motion_.nominal(kirchhoff, g);
  }

  void commit(const Particles& particles, int i, const Tensor<N>& g) const {
    const RateState<N, double, history_size> end = state_after(g);
    particles.stress.set(i, end.stress);
    particles.volume[i] = end.volume_ratio * particles.reference_volume(i);
    particles.history.set(i, end.history);
    if constexpr (TotalLagrangian) particles.deformation.set(i, motion_.end(g));
  }

 private:
  /// The displacement gradient with respect to the beginning of the step.
  template <class T>
  Tensor<N, T> current(const Tensor<N, T>& g) const {
    return TotalLagrangian ? product(g, cast<T>(inverse(motion_.start))) : g;
  }
  template <class T>
  RateState<N, T, history_size> state_after(const Tensor<N, T>& g) const {
    RateState<N, T, history_size> state{cast<T>(state_.stress), T(state_.volume_ratio), {}};
    unroll<history_size>([&](auto h) { state.history[h] = T(state_.history[h]); });
    advance_state(law_, current(g), dt_, state);
    return state;
  }

  const Law& law_;
  StepKinematics<N, TotalLagrangian> motion_;
  RateState<N, double, history_size> state_;
  double dt_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
