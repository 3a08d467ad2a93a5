#pragma once

#include "solver/materials/fluid.h"
#include "solver/materials/power.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Ideal gas that conducts no heat, p = (gamma - 1) rho e. It remembers its internal energy per reference
/// volume, E: p = (gamma - 1) E / J and dE = -(p + q) dJ, with the artificial pressure
/// q = rho L^2 (div v)^2 under compression. The stress of the state is that of q.
class IdealGas {
 public:
  static constexpr std::string_view name = "ideal_gas";
  static constexpr std::string_view source =
      "p = (gamma - 1) rho e; artificial pressure of von Neumann and Richtmyer 1950, eq. 13";
  static constexpr Parameter parameters[] = {
      {"heat_capacity_ratio", "1", "gamma", 1, 100},
      {"initial_pressure", "stress", "pressure at time 0", 0, 1e300},
      {"ambient_pressure", "stress", "pressure of the surroundings", 0, 1e300, 0, true},
      {"shock_length", "length", "length L over which the artificial pressure spreads shocks", 0, 1e300, 0, true}};
  static constexpr bool rate_form = true;
  static constexpr HistoryVariable history[] = {
      {"internal_energy", "stress", "internal energy per reference volume", 0}};

  static std::string_view objection(Dimension dimension, bool) { return objection_to_fluid(dimension); }

  IdealGas(const double* values, double density)
      : exponent_(values[0]),
        initial_energy_(values[1] / (values[0] - 1)),
        ambient_pressure_(values[2]),
        density_(density),
        squared_length_(values[3] * values[3]) {}

  void begin(std::uint64_t, double* h) const { h[0] = initial_energy_; }

  /// The trapezoidal rule for dE = -(p + q) dJ, solved for E at the end of the step.
  template <int N, class T>
  void advance(const Tensor<N, T>& g, double dt, RateState<N, T, 1>& state) const {
    const T& j = state.volume_ratio;
    const T before = j / determinant(identity<N, T>() + g), change = j - before;
    const T dilation = (dt > 0 ? 2 / dt : 0) * change / (j + before);
    const T artificial = choose(dilation < 0, density_ / j * squared_length_ * dilation * dilation, T(0.0));
    const double half = 0.5 * (exponent_ - 1);
    T& energy = state.history[0];
    energy = (energy * (1 - half * change / before) - artificial * change) / (1 + half * change / j);
    state.stress = plus_diagonal(SymmetricTensor<N, T>{}, -artificial);
  }
  template <int N, class T>
  SymmetricTensor<N, T> cauchy(const RateState<N, T, 1>& state) const {
    return plus_diagonal(state.stress, ambient_pressure_ - pressure(state));
  }
  /// What the gas can give to its surroundings and to itself: the internal energy above the initial one and
  /// the work against the ambient pressure.
  template <int N>
  double energy_density(const RateState<N, double, 1>& state) const {
    const double j = state.volume_ratio;
    return (state.history[0] - initial_energy_ + ambient_pressure_ * (j - 1)) / j;
  }
  /// rho (c + 2 sqrt(q / rho))^2: what the artificial pressure damps, an explicit step must follow as well.
  template <int N>
  LameConstants moduli(const RateState<N, double, 1>& state) const {
    const double root = std::sqrt(exponent_ * pressure(state)) + 2 * std::sqrt(-state.stress.diagonal[0]);
    return fluid_moduli(root * root);
  }

 private:
  template <int N, class T>
  T pressure(const RateState<N, T, 1>& state) const {
    return (exponent_ - 1) * state.history[0] / state.volume_ratio;
  }

  double exponent_, initial_energy_, ambient_pressure_, density_, squared_length_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
