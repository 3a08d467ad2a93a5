#pragma once

#include "solver/materials/deviatoric.h"
#include "solver/materials/linear_elastic.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// What laws with plastic flow remember.
inline constexpr HistoryVariable equivalent_plastic_strain_variable{
    "equivalent_plastic_strain", "1", "integral of sqrt(2/3 d : d) over time, d the rate of plastic strain", 0};
inline constexpr HistoryVariable dissipated_energy_variable{"dissipated_energy", "stress",
                                                            "energy per reference volume that has become heat", 0};

/// Isotropic elasticity in rate form, from which a plastic law returns to its yield surface (Simo and Hughes
/// 1998, section 3.3).
class ElasticPredictor {
 public:
  ElasticPredictor(const double* values, double density)
      : law_(values, density), moduli_(LameConstants::of(values[0], values[1])) {}

  /// The stress that the step would end with if it were elastic.
  template <int N, class T>
  SplitStress<N, T> predict(const Tensor<N, T>& g, const SymmetricTensor<N, T>& stress) const {
    return SplitStress<N, T>(stress + jaumann_change(moduli_, g, stress));
  }
  template <int N, int H>
  double energy_density(const RateState<N, double, H>& state) const {
    return law_.energy_density(RateState<N>{state.stress, state.volume_ratio, {}});
  }
  const LameConstants& moduli() const { return moduli_; }

 private:
  LinearElastic law_;
  LameConstants moduli_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
