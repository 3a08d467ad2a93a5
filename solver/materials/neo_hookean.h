#pragma once

#include <cmath>

#include "solver/materials/elastic_moduli.h"
#include "solver/materials/logarithm.h"
#include "solver/materials/plane_tensor.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Compressible neo-Hookean solid, strain energy per reference volume
/// mu/2 (tr(F F^T) - 3) - mu ln J + lambda/2 (ln J)^2.
class NeoHookean {
 public:
  static constexpr std::string_view name = "neo_hookean";
  static constexpr std::string_view source = "P = mu (F - F^-T) + lambda ln(J) F^-T; Asiri 2022, eq. 2.17";
  static constexpr Parameter parameters[] = {youngs_modulus_parameter, poissons_ratio_parameter};
  /// The state is the deformation gradient alone.
  static constexpr bool rate_form = false;

  static double wave_speed(std::span<const double> values, double density, Dimension dimension) {
    return std::sqrt(LameConstants(values[0], values[1]).wave_modulus(dimension) / density);
  }

  NeoHookean(const double* values, Dimension dimension) {
    const LameConstants lame(values[0], values[1]);
    lambda_ = lame.lambda;
    mu_ = lame.mu;
    plane_stress_ = dimension == Dimension::plane_stress;
    thinning_ = -lame.lambda / (lame.lambda + 2 * lame.mu);
  }

  /// What follows from a deformation gradient.
  template <class T>
  struct Response {
    SymmetricTensor<T> kirchhoff;  ///< J sigma = P F^T
    T volume_ratio;                ///< J, with the out-of-plane stretch
    T energy;                      ///< per reference volume
    T log_volume_ratio;
  };
  template <Dimension D, class T>
  Response<T> response(const PlaneTensor<T>& f) const {
    const T bxx = f.xx * f.xx + f.xy * f.xy, byy = f.yx * f.yx + f.yy * f.yy;
    const T bxy = f.xx * f.yx + f.xy * f.yy;
    const T area = determinant(f), log_area = natural_logarithm(area);
    T stretch = 1, log_stretch = 0;
    if constexpr (D == Dimension::plane_stress) {
      stretch = out_of_plane_stretch(log_area);
      log_stretch = natural_logarithm(stretch);
    }
    const T log_volume = log_area + log_stretch;
    const T pressure = lambda_ * log_volume - mu_;
    Response<T> r;
    r.kirchhoff = {mu_ * bxx + pressure, mu_ * byy + pressure, mu_ * bxy, T(0)};
    if constexpr (D == Dimension::plane_strain) r.kirchhoff.zz = mu_ + pressure;
    r.volume_ratio = area * stretch;
    r.log_volume_ratio = log_volume;
    r.energy =
        mu_ / 2 * (bxx + byy + stretch * stretch - 3) - mu_ * log_volume + lambda_ / 2 * log_volume * log_volume;
    return r;
  }

  /// Modulus of the fastest wave of a deformation whose squared stretch is b along one principal direction,
  /// over the reference volume. The acoustic tensor for the direction n is mu (n . F F^T n) 1 + c n n, where c
  /// is mu - lambda ln J and what a dilation adds to the pressure: lambda, or in plane stress what is left of it
  /// while the out-of-plane stretch s gives way, for which mu s^2 = mu - lambda ln J.
  double wave_modulus(double b, double log_volume_ratio) const {
    const double m = mu_ - lambda_ * log_volume_ratio;
    const double dilation = plane_stress_ ? lambda_ * 2 * m / (lambda_ + 2 * m) : lambda_;
    return mu_ * b + (m + dilation > 0 ? m + dilation : 0);
  }

 private:
  /// Solves tau_zz = mu (s^2 - 1) + lambda ln(area s) = 0 by Newton's method from the small-strain answer.
  /// Six steps reach rounding for areas between a quarter and four times the reference one.
  template <class T>
  T out_of_plane_stretch(T log_area) const {
    const T start = thinning_ * log_area;
    T s = 1 + start + T(0.5) * start * start;
    for (int iteration = 0; iteration < 6; ++iteration) {
      const T residual = mu_ * (s * s - 1) + lambda_ * (log_area + natural_logarithm(s));
      s = s - s * residual / (2 * mu_ * s * s + lambda_);
    }
    return s;
  }

  double lambda_, mu_;
  double thinning_;  ///< out-of-plane strain per in-plane dilation at small strain
  bool plane_stress_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
