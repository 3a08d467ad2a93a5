#pragma once

#include "solver/materials/elastic_moduli.h"
#include "solver/materials/tensor_inverse.h"
#include "solver/materials/tensor_products.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The displacement gradient `g` of a step, taken at its beginning, as one of the configuration at its middle.
template <int N, class T>
Tensor<N, T> mid_gradient(const Tensor<N, T>& g) {
  return product(g, inverse(plus_diagonal(0.5 * g, 1.0)));
}

/// `from` and R - 1 of a step whose displacement gradient at its middle is m.
template <int N, class T>
Tensor<N, T> turned(const Tensor<N, T>& m, const Tensor<N, T>& from) {
  if constexpr (N == 1) {
    return from;
  } else if constexpr (N == 2) {
    // The same but for products with zeros.
    const T a = 0.25 * (m(0, 1) - m(1, 0)), s = 2.0 / fused(a, a, T(1.0)), square = -(a * a);
    Tensor<N, T> r = from;
    unroll<2>([&](auto k) { r.diagonal[k] = fused(s, square, from.diagonal[k]); });
    r(0, 1) = fused(s, a, from(0, 1));
    r(1, 0) = fused(s, -a, from(1, 0));
    return r;
  } else {
    Tensor<N, T> a{};
    T sum = T(1.0);
    for_pairs<N>([&](auto i, auto j) {
      a(i, j) = 0.25 * (m(i, j) - m(j, i));
      a(j, i) = -a(i, j);
      sum = fused(a(i, j), a(i, j), sum);
    });
    return fused(2.0 / sum, a + product(a, a), from);
  }
}

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
  const Tensor<N, T> m = mid_gradient(g);
  return {symmetric_part(m), turned(m, identity<N, T>())};
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

/// What such a step of displacement gradient `g` adds to the stress, to as many digits as numbers of type T have:
/// with W = R - 1 and s the stress and half of what the strain adds, R s R^T - s = W s + (W s)^T + W s W^T.
template <int N, class T>
SymmetricTensor<N, T> jaumann_change(const LameConstants& lame, const Tensor<N, T>& g,
                                     const SymmetricTensor<N, T>& stress) {
  const Tensor<N, T> m = mid_gradient(g), w = turned(m, Tensor<N, T>{});
  const SymmetricTensor<N, T> half = hooke(LameConstants{0.5 * lame.lambda, 0.5 * lame.mu}, symmetric_part(m));
  const Tensor<N, T> ws = product(w, stress + half);
  const auto wsw = contract<SymmetricTensor<N, T>>([&](int i, int k) { return ws(i, k); },
                                                   [&](int k, int j) { return w(j, k); });
  return fused(2.0, half + symmetric_part(ws), wsw);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
