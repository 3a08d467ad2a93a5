#pragma once

#include "solver/materials/elastic_moduli.h"
#include "solver/materials/tensor_inverse.h"
#include "solver/materials/tensor_products.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Strain and rotation of a step.
template <int N, class T>
struct MidStep {
  SymmetricTensor<N, T> strain;
  Tensor<N, T> rotation;  ///< orthogonal
};

/// From the displacement gradient `g` of the step, taken at its beginning: both increments are those of the
/// configuration at the middle of the step, m = g (1 + g/2)^-1, and the rotation is exact, so that a rigid
/// rotation by any angle below pi is one and strains nothing (Hughes and Winget 1980). With a the axial vector
/// of half the spin, A x = a x x: rotation = (1 - A)^-1 (1 + A) = 1 + 2 (A + A^2) / (1 + a.a).
template <int N, class T>
MidStep<N, T> mid_step(const Tensor<N, T>& g) {
  const Tensor<N, T> m = product(g, inverse(plus_diagonal(0.5 * g, 1.0)));
  MidStep<N, T> r{symmetric_part(m), identity<N, T>()};
  if constexpr (N > 1) {
    Tensor<N, T> a{};
    T sum = T(1.0);
    for_pairs<N>([&](auto i, auto j) {
      a(i, j) = 0.25 * (m(i, j) - m(j, i));
      a(j, i) = -a(i, j);
      sum = fused(a(i, j), a(i, j), sum);
    });
    r.rotation = fused(2.0 / sum, a + product(a, a), r.rotation);
  }
  return r;
}

/// lambda tr(e) 1 + 2 mu e
template <int N, class T>
SymmetricTensor<N, T> hooke(const LameConstants& lame, const SymmetricTensor<N, T>& strain) {
  return plus_diagonal((2 * lame.mu) * strain, lame.lambda * trace(strain));
}

/// Cauchy stress after an elastic step with the Jaumann rate. Half of what the strain adds is turned with the
/// stress that was there, for it arises while the rotation goes on: without that a step's error would be of
/// second order, not third.
template <int N, class T>
SymmetricTensor<N, T> jaumann_step(const LameConstants& lame, const MidStep<N, T>& step,
                                   const SymmetricTensor<N, T>& stress) {
  const SymmetricTensor<N, T> half = hooke(lame, 0.5 * step.strain);
  return push_forward(step.rotation, stress + half) + half;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
