#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "solver/materials/wave_modulus.h"
#include "tests/epsilon.h"

namespace trajan::test {

/// A point of a rate law that is strained step by step.
template <class Law, int N>
class OnePoint {
 public:
  using State = RateState<N, double, history_count<Law>()>;

  explicit OnePoint(const Law& law, std::uint64_t particle = 0)
      : law_(law), state_{{}, 1, initial_history(law, particle)} {}

  void step(const Tensor<N>& g, double dt = 1) { advance_state(law_, g, dt, state_); }
  /// A step of uniaxial stress.
  void pull(double g, double dt = 1) requires(N == 1) {
    Tensor<1> gradient{{g, 0, 0}, {}};
    for (int i = 0; i < most_corrections; ++i)
      if (correct_rest(law_, state_, dt, gradient)) return step(gradient, dt);
    ADD_FAILURE() << "the stress across stays";
  }
  /// A step with stresses across that stay what they are: zero of the first step's lateral residual by the
  /// secant rule, the two axes being alike.
  void compress_triaxially(double g, double lateral_stress) requires(N == 1) {
    double a = 0, b = -0.3 * g, ra = residual(g, a, lateral_stress);
    for (int i = 0; i < 100 && std::abs(b - a) > 1e-15; ++i) {
      const double rb = residual(g, b, lateral_stress);
      const double next = rb == ra ? b : b - rb * (b - a) / (rb - ra);
      a = b, ra = rb, b = next;
    }
    step({{g, b, b}, {}});
    lateral_step_ = b;
  }

  const State& state() const { return state_; }
  SymmetricTensor<N> stress() const { return cauchy_stress(law_, state_); }
  double axial() const { return stress().diagonal[0]; }
  double history(std::size_t i) const { return state_.history[i]; }
  /// Per reference volume.
  double stored() const { return state_.volume_ratio * law_.energy_density(state_); }
  double dissipated() const { return law_.dissipated_energy(state_.history); }
  double equivalent() const {
    const SymmetricTensor<N> s = deviator(stress());
    return std::sqrt(1.5 * double_contraction(s, s));
  }
  /// Strain across in the last triaxial step.
  double lateral_step() const { return lateral_step_; }

 private:
  double residual(double g, double across, double lateral_stress) const {
    State state = state_;
    advance_state(law_, Tensor<1>{{g, across, across}, {}}, 1.0, state);
    return cauchy_stress(law_, state).diagonal[1] - lateral_stress;
  }

  const Law& law_;
  State state_;
  double lateral_step_ = 0;
};

}  // namespace trajan::test
