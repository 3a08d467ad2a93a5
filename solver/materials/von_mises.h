#pragma once

#include "solver/materials/elastic_predictor.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Metal plasticity: yield condition of von Mises with linear isotropic hardening,
/// sqrt(3 J_2) <= yield_stress + hardening_modulus * equivalent plastic strain.
class VonMises {
 public:
  static constexpr std::string_view name = "von_mises";
  static constexpr std::string_view source =
      "radial return, Simo and Hughes 1998, box 3.2; Jaumann rate of the Cauchy stress";
  static constexpr Parameter parameters[] = {
      youngs_modulus_parameter,
      poissons_ratio_parameter,
      {"yield_stress", "stress", "yield stress in uniaxial tension", 0, 1e300},
      {"hardening_modulus", "stress", "slope of the yield stress over the equivalent plastic strain", 0, 1e300, 0,
       true}};
  static constexpr bool rate_form = true;
  static constexpr HistoryVariable history[] = {equivalent_plastic_strain_variable};

  VonMises(const double* values, double density)
      : elastic_(values, density), yield_stress_(values[2]), hardening_modulus_(values[3]) {}

  template <int N, class T>
  void advance(const Tensor<N, T>& g, double /*dt*/, RateState<N, T, 1>& state) const {
    const SplitStress<N, T> trial = elastic_.predict(g, state.stress);
    T& strain = state.history[0];
    const double three_mu = 3 * elastic_.moduli().mu;
    const T equivalent = trial.equivalent();
    const T excess = equivalent - (yield_stress_ + hardening_modulus_ * strain);
    const bool yields = excess > 0;
    const T increment = choose(yields, excess * (1 / (three_mu + hardening_modulus_)), T(0.0));
    const T share = choose(yields, 1 - three_mu * increment / equivalent, T(1.0));
    state.stress = trial.with(share, trial.mean);
    strain = strain + increment;
  }

  template <int N>
  double energy_density(const RateState<N, double, 1>& state) const {
    return elastic_.energy_density(state);
  }
  double dissipated_energy(const std::array<double, 1>& h) const {
    return (yield_stress_ + 0.5 * hardening_modulus_ * h[0]) * h[0];
  }
  template <int N>
  LameConstants moduli(const RateState<N, double, 1>&) const {
    return elastic_.moduli();
  }

 private:
  ElasticPredictor elastic_;
  double yield_stress_, hardening_modulus_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
