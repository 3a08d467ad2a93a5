#pragma once

#include "solver/materials/dimension.h"
#include "solver/materials/law.h"
#include "solver/materials/orthotropy.h"
#include "solver/materials/wave_modulus.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Orthotropic elasticity between the Green-Lagrange strain and the second Piola-Kirchhoff stress, in a frame
/// that the material carries along: strain energy per reference volume S : E / 2.
class OrthotropicElastic {
 public:
  static constexpr std::string_view name = "orthotropic_elastic";
  static constexpr std::string_view source = "S = C : E; nine constants by Jones 1999, eq. 2.25";
  static constexpr auto& parameters = orthotropy_parameters;
  static constexpr bool rate_form = false;

  static Objection check(const double* values, Dimension dimension) { return check_orthotropy(values, dimension); }

  OrthotropicElastic(const double* values, double /*density*/)
      : stiffness_(orthotropic_stiffness(values)), frame_(frame_axes(values + 9)) {
    for (int d = 0; d < dimension_count; ++d)
      wave_modulus_[d] = fastest_wave(stiffness_, frame_, static_cast<Dimension>(d));
  }

  template <int N, class T>
  Response<N, T> response(const Tensor<N, T>& f) const {
    const SymmetricTensor<N, T> strain = 0.5 * plus_diagonal(right_cauchy_green(f), -1.0);
    const SymmetricTensor<N, T> s = stress(strain);
    return {push_forward(f, s), 0.5 * double_contraction(s, strain)};
  }

  /// A bound. The acoustic tensor for the reference normal n is (n . S n) 1 + F A(n) F^T, A being that at rest.
  template <Dimension D, int N>
  double wave_modulus(const Tensor<N>& f, bool total_lagrangian) const {
    const std::array<double, 3> b = squared_stretches(f);
    const std::array<double, 3> s =
        eigenvalues(stress(SymmetricTensor<N>(0.5 * plus_diagonal(right_cauchy_green(f), -1.0))));
    const double largest = *std::max_element(b.begin(), b.begin() + N);
    const double pull = std::max(0.0, *std::max_element(s.begin(), s.begin() + N));
    const double modulus = pull + largest * wave_modulus_[static_cast<int>(D)];
    return total_lagrangian ? modulus : modulus * largest;
  }

 private:
  static constexpr int dimension_count = static_cast<int>(Dimension::solid) + 1;

  template <int N, class T>
  SymmetricTensor<N, T> stress(const SymmetricTensor<N, T>& strain) const {
    Tensor<N, T> to_frame = identity<N, T>();
    unroll<N>([&](auto i) { unroll<N>([&](auto j) { to_frame(i, j) = T(frame_(j, i)); }); });
    const SymmetricTensor<N, T> e = push_forward(to_frame, strain);
    SymmetricTensor<N, T> s{};
    unroll<3>([&](auto i) {
      s.diagonal[i] = stiffness_.normal[i][0] * e.diagonal[0] + stiffness_.normal[i][1] * e.diagonal[1] +
                      stiffness_.normal[i][2] * e.diagonal[2];
    });
    unroll<SymmetricTensor<N, T>::off_count>([&](auto k) { s.off[k] = (2 * stiffness_.shear[k]) * e.off[k]; });
    return push_forward(transpose(to_frame), s);
  }

  OrthotropicStiffness stiffness_;
  Tensor<3> frame_;  ///< its columns are the material's axes
  double wave_modulus_[dimension_count] = {};
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
