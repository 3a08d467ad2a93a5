#pragma once

#include "solver/materials/law.h"
#include "solver/materials/logarithm.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Compressible neo-Hookean solid, strain energy per reference volume
/// mu/2 (tr(F F^T) - 3) - mu ln J + lambda/2 (ln J)^2.
class NeoHookean {
 public:
  static constexpr std::string_view name = "neo_hookean";
  static constexpr std::string_view source = "P = mu (F - F^-T) + lambda ln(J) F^-T; Asiri 2022, eq. 2.17";
  static constexpr Parameter parameters[] = {youngs_modulus_parameter, poissons_ratio_parameter};
  static constexpr bool rate_form = false;

  NeoHookean(const double* values, double /*density*/) : lame_(LameConstants::of(values[0], values[1])) {}

  template <int N, class T>
  Response<N, T> response(const Tensor<N, T>& f) const {
    const SymmetricTensor<N, T> b = left_cauchy_green(f);
    const T log_volume = natural_logarithm(determinant(f));
    return {plus_diagonal(lame_.mu * b, lame_.lambda * log_volume - lame_.mu),
            (lame_.mu / 2) * (trace(b) - 3.0) + ((lame_.lambda / 2) * log_volume - lame_.mu) * log_volume};
  }

  /// As `response`, by H = F - 1: b - 1 = H + H^T + H H^T.
  template <int N, class T>
  SymmetricTensor<N, T> kirchhoff_of_change(const Tensor<N, T>& h) const {
    return plus_diagonal(fused(2 * lame_.mu, symmetric_part(h), lame_.mu * left_cauchy_green(h)),
                         lame_.lambda * logarithm_of_one_more(dilation(h)));
  }

 private:
  LameConstants lame_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
