#pragma once

#include "solver/materials/law.h"
#include "solver/materials/mid_step.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Hooke's law between the linear strain e = sym(F - 1) of the reference configuration and the first
/// Piola-Kirchhoff stress: linear elasticity, for comparison with the Green-Lagrange strain
/// (st_venant_kirchhoff) where rotations matter. A rigid rotation strains it.
class LinearStrainElastic {
 public:
  static constexpr std::string_view name = "linear_strain_elastic";
  static constexpr std::string_view source =
      "P = lambda tr(e) 1 + 2 mu e, e = sym(grad u); Holzapfel 2000, section 2.4; Asiri 2022, section 7.3";
  static constexpr Parameter parameters[] = {youngs_modulus_parameter, poissons_ratio_parameter};
  static constexpr bool rate_form = false;
  static constexpr bool geometrically_linear = true;

  static std::string_view objection(Dimension, bool total_lagrangian) {
    return total_lagrangian ? "" : "it measures strain from the reference configuration, which this scheme leaves";
  }

  LinearStrainElastic(const double* values, double /*density*/) : lame_(LameConstants::of(values[0], values[1])) {}

  template <int N, class T>
  Response<N, T> response(const Tensor<N, T>& f) const {
    const SymmetricTensor<N, T> strain = plus_diagonal(symmetric_part(f), -1.0);
    const SymmetricTensor<N, T> s = hooke(lame_, strain);
    return {s, 0.5 * double_contraction(s, strain)};
  }

  template <Dimension D, int N>
  double wave_modulus(const Tensor<N>&, bool /*total_lagrangian*/) const {
    return lame_.wave_modulus(D);
  }

 private:
  LameConstants lame_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
