#pragma once

#include <numbers>

#include "solver/materials/elastic_predictor.h"
#include "solver/materials/power.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Soil and rock: sqrt(J_2) + eta p <= xi c with the mean stress p (tension is positive), the cone through
/// the compressive edges of the pyramid of Mohr and Coulomb, and p <= tension cut-off. Plastic flow on the cone
/// is that of the potential sqrt(J_2) + eta' p, in which the dilation angle stands in place of the friction
/// angle; the cut-off gives way in volume alone. There is no hardening, and all returns are in closed form.
class DruckerPrager {
 public:
  static constexpr std::string_view name = "drucker_prager";
  static constexpr std::string_view source =
      "de Souza Neto, Peric and Owen 2008, section 6.4.4 and box 8.8; Jaumann rate of the Cauchy stress";
  static constexpr Parameter parameters[] = {
      youngs_modulus_parameter,
      poissons_ratio_parameter,
      {"cohesion", "stress", "cohesion", 0, 1e300, std::numeric_limits<double>::quiet_NaN(), true},
      {"friction_angle", "degrees", "angle of internal friction", 0, 90, std::numeric_limits<double>::quiet_NaN(),
       true},
      {"dilation_angle", "degrees", "angle of dilation", 0, 90, 0, true},
      {"tension_cutoff", "stress", "largest mean stress", 0, 1e300, not_given, true}};
  static constexpr bool rate_form = true;
  static constexpr HistoryVariable history[] = {equivalent_plastic_strain_variable, dissipated_energy_variable};

  static Objection check(const double* values, Dimension) {
    if (values[2] == 0 && values[3] == 0)
      return {"there is neither cohesion nor friction", "give cohesion or friction_angle greater than 0"};
    if (values[4] > values[3])
      return {"dilation_angle is greater than friction_angle", "give at most friction_angle"};
    if (values[5] < not_given && values[5] * std::tan(radians(values[3])) > values[2])
      return {"tension_cutoff lies beyond the cone's apex", "give at most cohesion / tan(friction_angle)"};
    return {};
  }
  static std::string_view objection(Dimension dimension, bool) {
    if (dimension != Dimension::plane_stress && dimension != Dimension::bar) return "";
    return "friction is a matter of all three principal stresses, of which this one sets some to zero; "
           "use plane strain, axisymmetry or a solid";
  }

  DruckerPrager(const double* values, double density)
      : elastic_(values, density),
        eta_(slope(values[3])),
        dilation_(slope(values[4])),
        cohesion_(cohesion_factor(values[3]) * values[2]),
        cutoff_(eta_ * values[5] < cohesion_ ? values[5] : cohesion_ / eta_) {}

  template <int N, class T>
  void advance(const Tensor<N, T>& g, double /*dt*/, RateState<N, T, 2>& state) const {
    const SplitStress<N, T> trial = elastic_.predict(g, state.stress);
    const double mu = elastic_.moduli().mu, bulk = elastic_.moduli().bulk_modulus();
    const T shear = square_root(trial.second_invariant());
    // First the cone alone, then the corner of cone and cut-off, of which the cone's apex is one.
    const T beyond = larger(shear + eta_ * trial.mean - cohesion_, T(0.0));
    const T on_cone = trial.mean - beyond * (bulk * dilation_ / (mu + bulk * eta_ * dilation_));
    const T mean = smaller(on_cone, T(cutoff_));
    const T new_shear = smaller(shear, larger(cohesion_ - eta_ * mean, T(0.0)));
    const bool slips = new_shear < shear;
    state.stress = trial.with(choose(slips, new_shear / choose(slips, shear, T(1.0)), T(1.0)), mean);
    // The rate of plastic shear is the multiplier's, along s / (2 sqrt(J_2)).
    const T slip = (shear - new_shear) * (1 / mu);
    state.history[0] = state.history[0] + slip * (1 / std::numbers::sqrt3);
    const T work = new_shear * slip + mean * (trial.mean - mean) * (1 / bulk);
    state.history[1] = state.history[1] + state.volume_ratio * work;
  }

  template <int N>
  double energy_density(const RateState<N, double, 2>& state) const {
    return elastic_.energy_density(state);
  }
  double dissipated_energy(const std::array<double, 2>& h) const { return h[1]; }
  template <int N>
  LameConstants moduli(const RateState<N, double, 2>&) const {
    return elastic_.moduli();
  }

 private:
  static double radians(double degrees) { return degrees * (std::numbers::pi / 180); }
  /// eta for the compressive edges of Mohr and Coulomb's pyramid.
  static double slope(double angle) {
    const double sine = std::sin(radians(angle));
    return 6 * sine / (std::numbers::sqrt3 * (3 - sine));
  }
  static double cohesion_factor(double angle) {
    return 6 * std::cos(radians(angle)) / (std::numbers::sqrt3 * (3 - std::sin(radians(angle))));
  }

  ElasticPredictor elastic_;
  double eta_, dilation_;
  double cohesion_;  ///< xi c
  double cutoff_;    ///< mean stress of the cut-off, or of the apex if that is less
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
