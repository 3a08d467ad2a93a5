#pragma once

#include "solver/materials/elastic_predictor.h"
#include "solver/materials/power.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Metal plasticity at high rates: yield condition of von Mises with the flow stress of Johnson and Cook,
///   (A + B eps^n) (1 + C ln max(rate / reference_rate, 1)) (1 - T*^m),
///   T* = (T - reference_temperature) / (melting_temperature - reference_temperature) within 0 and 1.
/// A share of the plastic work heats the particle; no heat is conducted. Within a step the temperature is that
/// of its beginning.
class JohnsonCook {
 public:
  static constexpr std::string_view name = "johnson_cook";
  static constexpr std::string_view source =
      "Johnson and Cook 1983; radial return, Simo and Hughes 1998, section 3.3; Taylor and Quinney 1934";
  static constexpr Parameter parameters[] = {
      youngs_modulus_parameter,
      poissons_ratio_parameter,
      {"yield_stress", "stress", "A, yield stress at the reference rate and temperature", 0, 1e300},
      {"hardening_coefficient", "stress", "B", 0, 1e300, 0, true},
      {"hardening_exponent", "1", "n", 0, 10, 1},
      {"rate_coefficient", "1", "C", 0, 10, 0, true},
      {"reference_rate", "1/time", "rate of plastic strain below which it has no influence", 0, 1e300, 1},
      {"thermal_exponent", "1", "m", 0, 100, 1},
      {"reference_temperature", "temperature", "there is no softening below it", -1e300, 1e300, 0},
      {"melting_temperature", "temperature", "at which no strength is left", -1e300, 1e300, not_given},
      {"initial_temperature", "temperature", "temperature at time 0; that of reference if not given", -1e300,
       1e300, not_given},
      {"heat_capacity", "energy/(mass temperature)", "heat capacity", 0, 1e300, not_given},
      {"taylor_quinney", "1", "share of plastic work that becomes heat", 0, 1, 0.9, true, true}};
  static constexpr bool rate_form = true;
  static constexpr HistoryVariable history[] = {equivalent_plastic_strain_variable,
                                                {"temperature", "temperature", "temperature", 0},
                                                dissipated_energy_variable};
  using History = std::array<double, 3>;

  static Objection check(const double* values, Dimension) {
    if (values[9] > values[8]) return {};
    return {"melting_temperature is not above reference_temperature", "give a higher melting_temperature"};
  }

  JohnsonCook(const double* values, double density)
      : elastic_(values, density),
        yield_stress_(values[2]),
        hardening_(values[3]),
        exponent_(values[4]),
        rate_(values[5]),
        reference_rate_(values[6]),
        thermal_exponent_(values[7]),
        reference_temperature_(values[8]),
        initial_temperature_(values[10] < not_given ? values[10] : values[8]),
        inverse_range_(1 / (values[9] - values[8])),
        heating_(values[12] / (density * values[11])) {}

  void begin(std::uint64_t, double* h) const { h[1] = initial_temperature_; }

  template <int N, class T>
  void advance(const Tensor<N, T>& g, double dt, RateState<N, T, 3>& state) const {
    const SplitStress<N, T> trial = elastic_.predict(g, state.stress);
    T &strain = state.history[0], &temperature = state.history[1];
    const T equivalent = trial.equivalent();
    const Strength<T> strength{strain, dt * reference_rate_, softening(temperature)};
    const T excess = equivalent - flow(strength, T(0.0)).stress;
    const bool yields = excess > 0;
    const T increment = choose(yields, plastic_increment(strength, equivalent, excess), T(0.0));
    const T flow_stress = equivalent - 3 * elastic_.moduli().mu * increment;
    state.stress = trial.with(choose(yields, flow_stress / equivalent, T(1.0)), trial.mean);
    strain = strain + increment;
    const T work = state.volume_ratio * flow_stress * increment;
    temperature = temperature + heating_ * work;
    state.history[2] = state.history[2] + work;
  }

  template <int N>
  double energy_density(const RateState<N, double, 3>& state) const {
    return elastic_.energy_density(state);
  }
  double dissipated_energy(const History& h) const { return h[2]; }
  template <int N>
  LameConstants moduli(const RateState<N, double, 3>&) const {
    return elastic_.moduli();
  }

 private:
  /// What the flow stress depends on beside the increment of plastic strain.
  template <class T>
  struct Strength {
    T strain;     ///< at the beginning of the step
    double slow;  ///< the increment up to which the rate has no influence
    T softening;
  };
  template <class T>
  struct Flow {
    T stress, slope;  ///< and its derivative by the increment
  };

  template <class T>
  T softening(const T& temperature) const {
    const T relative = (temperature - reference_temperature_) * inverse_range_;
    const T strength = 1 - power(relative, thermal_exponent_);
    return choose(strength > 0, strength, T(0.0));
  }

  template <class T>
  Flow<T> flow(const Strength<T>& s, const T& increment) const {
    const T strain = s.strain + increment, hardening = hardening_ * power(strain, exponent_);
    const bool fast = increment > s.slow;
    const T rate = 1 + rate_ * choose(fast, natural_logarithm(choose(fast, increment / s.slow, T(1.0))), T(0.0));
    const T still = s.softening * (yield_stress_ + hardening);
    const T by_hardening = s.softening * exponent_ * hardening / choose(strain > smallest, strain, T(smallest));
    return {still * rate,
            by_hardening * rate + choose(fast, still * rate_ / choose(fast, increment, T(1.0)), T(0.0))};
  }

  /// Solves 3 mu d + flow stress(d) = equivalent trial stress for the increment d of the plastic strain. As a
  /// function of ln d the left-hand side is convex and increases, so that Newton's method comes down to the
  /// answer from any greater start without fail. The least of the increments that elastic relaxation, hardening
  /// or rate alone would answer the excess with is such a start, and so near that six steps reach rounding.
  template <class T>
  T plastic_increment(const Strength<T>& s, const T& equivalent, const T& excess) const {
    const double three_mu = 3 * elastic_.moduli().mu;
    const T least = choose(excess > smallest, excess, T(smallest));
    T d = least * (1 / three_mu);
    const T share = least / (s.softening * hardening_ + 1e-9 * three_mu);
    const T hardened = power(power(s.strain, exponent_) + share, 1 / exponent_) - s.strain;
    d = choose((hardened > 1e-12 * s.strain) & (hardened < d), hardened, d);
    const T ratio = least / (s.softening * yield_stress_ * rate_ + smallest);
    const T rated = s.slow * exponential(choose(ratio < 600, ratio, T(600)));
    d = choose(rated < d, rated, d);
    unroll<6>([&](auto) {
      const Flow<T> f = flow(s, d);
      d = d * exponential((equivalent - three_mu * d - f.stress) / (d * (three_mu + f.slope)));
    });
    return d;
  }

  static constexpr double smallest = 1e-290;

  ElasticPredictor elastic_;
  double yield_stress_, hardening_, exponent_, rate_, reference_rate_, thermal_exponent_;
  double reference_temperature_, initial_temperature_;
  double inverse_range_;  ///< of temperatures from reference to melting
  double heating_;        ///< temperature per plastic work and reference volume
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
