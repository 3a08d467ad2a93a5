#pragma once

#include <cmath>

#include "solver/materials/elastic_moduli.h"
#include "solver/materials/plane_tensor.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Isotropic linear elasticity in rate form with the Jaumann rate of the Cauchy stress.
class LinearElastic {
 public:
  static constexpr std::string_view name = "linear_elastic";
  static constexpr std::string_view source = "Jaumann rate of the Cauchy stress; Asiri 2022, eq. 2.16";
  static constexpr Parameter parameters[] = {youngs_modulus_parameter, poissons_ratio_parameter};
  /// The state is Cauchy stress and volume, advanced step by step.
  static constexpr bool rate_form = true;

  static double wave_speed(std::span<const double> values, double density, Dimension dimension) {
    return std::sqrt(LameConstants(values[0], values[1]).wave_modulus(dimension) / density);
  }

  LinearElastic(const double* values, Dimension dimension) : LinearElastic({values[0], values[1]}, dimension) {}

  /// Advances stress and volume by a step whose displacement gradient, taken at the beginning of the step,
  /// is `g`. Strain and rotation increments are those of the configuration at the middle of the step and
  /// the rotation is exact, so that a rigid rotation by any angle below pi turns the stress and does
  /// nothing else (Hughes and Winget 1980). Half of what the strain adds is turned as well, for it arises
  /// while the rotation goes on: without that a step's error would be of second order, not third.
  template <Dimension D, class T>
  void advance(const PlaneTensor<T>& g, SymmetricTensor<T>& stress, T& volume) const {
    const T half = T(0.5);
    const PlaneTensor<T> to_middle{1 + half * g.xx, half * g.xy, half * g.yx, 1 + half * g.yy};
    const PlaneTensor<T> m = product(g, inverse(to_middle));
    const T spin = half * (m.yx - m.xy), shear = m.xy + m.yx, dilation = m.xx + m.yy;
    // Half the rotation angle has the tangent spin / 2.
    const T a = half * spin, q = 1 / (1 + a * a);
    const T cosine = (1 - a * a) * q, sine = 2 * a * q;
    const T pressure = lambda_ * dilation, half_shear = half * mu_ * shear;
    const T half_xx = half * pressure + mu_ * m.xx, half_yy = half * pressure + mu_ * m.yy;
    const T xx = stress.xx + half_xx, yy = stress.yy + half_yy, xy = stress.xy + half_shear;
    const T mean = half * (xx + yy), difference = half * (xx - yy);
    const T cosine2 = cosine * cosine - sine * sine, sine2 = 2 * sine * cosine;
    const T turned = difference * cosine2 - xy * sine2;
    stress.xx = mean + turned + half_xx;
    stress.yy = mean - turned + half_yy;
    stress.xy = difference * sine2 + xy * cosine2 + half_shear;
    if constexpr (D == Dimension::plane_strain) stress.zz += pressure;
    volume *= determinant(PlaneTensor<T>{1 + g.xx, g.xy, g.yx, 1 + g.yy}) * (1 + thinning_ * dilation);
  }

  /// Strain energy per current volume of the present stress.
  template <class T>
  T energy_density(const SymmetricTensor<T>& s) const {
    const T normal =
        s.xx * s.xx + s.yy * s.yy + s.zz * s.zz - 2 * poissons_ratio_ * (s.xx * s.yy + s.yy * s.zz + s.zz * s.xx);
    return normal / (2 * youngs_modulus_) + s.xy * s.xy / two_mu_;
  }

  /// Modulus of the fastest wave per current volume.
  double wave_modulus() const { return lambda_ + two_mu_; }

 private:
  struct Moduli {
    double youngs_modulus, poissons_ratio;
  };
  LinearElastic(Moduli m, Dimension dimension)
      : youngs_modulus_(m.youngs_modulus), poissons_ratio_(m.poissons_ratio) {
    const LameConstants lame(m.youngs_modulus, m.poissons_ratio);
    lambda_ = lame.in_plane_lambda(dimension);
    mu_ = lame.mu;
    two_mu_ = 2 * lame.mu;
    if (dimension == Dimension::plane_stress) thinning_ = -lame.lambda / (lame.lambda + 2 * lame.mu);
  }

  double youngs_modulus_, poissons_ratio_, lambda_, mu_, two_mu_;
  double thinning_ = 0;  ///< out-of-plane strain per in-plane dilation
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
