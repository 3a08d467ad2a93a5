#pragma once

#include "solver/materials/law.h"
#include "solver/materials/mid_step.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Isotropic linear elasticity in rate form with the Jaumann rate of the Cauchy stress.
class LinearElastic {
 public:
  static constexpr std::string_view name = "linear_elastic";
  static constexpr std::string_view source = "Jaumann rate of the Cauchy stress; Asiri 2022, eq. 2.16";
  static constexpr Parameter parameters[] = {youngs_modulus_parameter, poissons_ratio_parameter};
  static constexpr bool rate_form = true;

  LinearElastic(const double* values, double /*density*/) : lame_(LameConstants::of(values[0], values[1])) {}

  template <int N, class T>
  void advance(const Tensor<N, T>& g, double /*dt*/, RateState<N, T>& state) const {
    state.stress = state.stress + stress_change(g, state.stress);
  }

  /// What `advance` adds to the stress.
  template <int N, class T>
  SymmetricTensor<N, T> stress_change(const Tensor<N, T>& g, const SymmetricTensor<N, T>& stress) const {
    return jaumann_change(lame_, g, stress);
  }

  /// The strain across is minus Poisson's part of that in the plane or along the bar; g (1 + g/2)^-1 is it.
  template <int N, class T>
  void relax(Tensor<N, T>& g, const RateState<N, T>&) const {
    const SymmetricTensor<N, T> strain = mid_strain(g);
    T dilation = strain.diagonal[0];
    unroll<N - 1>([&](auto k) { dilation = dilation + strain.diagonal[k + 1]; });
    const T across = lame_.thinning(N == 1 ? Dimension::bar : Dimension::plane_stress) * dilation;
    unroll<3 - N>([&](auto k) { g.diagonal[N + k] = across / (1.0 - 0.5 * across); });
  }

  template <int N, class T>
  T energy_density(const RateState<N, T>& state) const {
    const SymmetricTensor<N, T>& s = state.stress;
    const T pressure = trace(s);
    return (0.25 / lame_.mu) * (double_contraction(s, s) -
                                lame_.poissons_ratio() / (1 + lame_.poissons_ratio()) * pressure * pressure);
  }

  template <int N>
  LameConstants moduli(const RateState<N>&) const {
    return lame_;
  }

 private:
  LameConstants lame_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
