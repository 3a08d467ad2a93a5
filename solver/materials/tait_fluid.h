#pragma once

#include "solver/materials/fluid.h"
#include "solver/materials/mid_step.h"
#include "solver/materials/power.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Newtonian fluid, p = K / gamma (J^-gamma - 1) and deviatoric stress 2 mu dev(d) with the rate of strain d.
/// The stress of the state is the viscous one.
class TaitFluid {
 public:
  static constexpr std::string_view name = "tait_fluid";
  static constexpr std::string_view source = "equation of state of Tait 1888 and Murnaghan 1944; Batchelor 1967";
  static constexpr Parameter parameters[] = {
      {"bulk_modulus", "stress", "bulk modulus at rest", 0, 1e300},
      {"exponent", "1", "gamma", 1, 100, 7},
      {"viscosity", "stress time", "dynamic viscosity", 0, 1e300, 0, true},
      {"lowest_pressure", "stress", "pressure at which the fluid tears", -1e300, 0, -not_given, false, true}};
  static constexpr bool rate_form = true;
  static constexpr HistoryVariable history[] = {
      {"dissipated_energy", "stress", "energy per reference volume that has become heat", 0}};

  static std::string_view objection(Dimension dimension, bool) { return objection_to_fluid(dimension); }

  TaitFluid(const double* values, double density)
      : bulk_modulus_(values[0]),
        exponent_(values[1]),
        viscosity_(values[2]),
        lowest_pressure_(values[3]),
        density_(density) {
    const double torn = 1 + exponent_ * lowest_pressure_ / bulk_modulus_;
    tearing_ratio_ = torn > 0 ? std::pow(torn, -1 / exponent_) : 1e300;
  }

  template <int N, class T>
  void advance(const Tensor<N, T>& g, double dt, RateState<N, T, 1>& state) const {
    const double rate = dt > 0 ? 1 / dt : 0;
    const SymmetricTensor<N, T> strain_rate = rate * deviator(mid_strain(g));
    state.stress = (2 * viscosity_) * strain_rate;
    state.history[0] = state.history[0] + dt * state.volume_ratio * double_contraction(state.stress, strain_rate);
  }
  template <int N, class T>
  SymmetricTensor<N, T> cauchy(const RateState<N, T, 1>& state) const {
    return plus_diagonal(state.stress, -pressure(state.volume_ratio));
  }
  /// The work that compression has stored, the integral of -p dJ.
  template <int N>
  double energy_density(const RateState<N, double, 1>& state) const {
    const double j = state.volume_ratio < tearing_ratio_ ? state.volume_ratio : tearing_ratio_;
    const double power_of_j = power(j, 1 - exponent_);
    const double stored = bulk_modulus_ / exponent_ * ((power_of_j - 1) / (exponent_ - 1) + (j - 1));
    return (stored - lowest_pressure_ * (state.volume_ratio - j)) / state.volume_ratio;
  }
  double dissipated_energy(const std::array<double, 1>& h) const { return h[0]; }
  template <int N>
  LameConstants moduli(const RateState<N, double, 1>& state) const {
    return fluid_moduli(bulk_modulus_ * power(state.volume_ratio, -exponent_));
  }
  /// That of longitudinal waves, whose deviatoric strain is 2/3 of their strain.
  double diffusivity() const { return 4.0 / 3 * viscosity_ / density_; }

 private:
  template <class T>
  T pressure(const T& j) const {
    const T p = bulk_modulus_ / exponent_ * (power(j, -exponent_) - 1);
    return choose(p > lowest_pressure_, p, T(lowest_pressure_));
  }

  double bulk_modulus_, exponent_, viscosity_, lowest_pressure_, density_;
  double tearing_ratio_;  ///< volume ratio from which on the pressure is the lowest
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
