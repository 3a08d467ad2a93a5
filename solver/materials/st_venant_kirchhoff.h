#pragma once

#include "solver/materials/law.h"
#include "solver/materials/mid_step.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// St Venant-Kirchhoff solid: Hooke's law between the Green-Lagrange strain E = (F^T F - 1) / 2 and the second
/// Piola-Kirchhoff stress, strain energy per reference volume lambda/2 (tr E)^2 + mu E : E. It softens in strong
/// compression, where it has no physical meaning.
class StVenantKirchhoff {
 public:
  static constexpr std::string_view name = "st_venant_kirchhoff";
  static constexpr std::string_view source = "S = lambda tr(E) 1 + 2 mu E; Holzapfel 2000, eq. 6.151";
  static constexpr Parameter parameters[] = {youngs_modulus_parameter, poissons_ratio_parameter};
  static constexpr bool rate_form = false;

  StVenantKirchhoff(const double* values, double /*density*/) : lame_(LameConstants::of(values[0], values[1])) {}

  template <int N, class T>
  Response<N, T> response(const Tensor<N, T>& f) const {
    const SymmetricTensor<N, T> strain = 0.5 * plus_diagonal(right_cauchy_green(f), -1.0);
    const SymmetricTensor<N, T> s = hooke(lame_, strain);
    return {push_forward(f, s), 0.5 * double_contraction(s, strain)};
  }

 private:
  LameConstants lame_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
