#pragma once

#include "solver/materials/elastic_moduli.h"
#include "solver/materials/tensor_inverse.h"
#include "solver/materials/tensor_products.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The displacement gradient `g` of a step, taken at its beginning, as one of the configuration at its middle:
/// m = g (1 + g/2)^-1. Strain and spin increments are its parts (Hughes and Winget 1980).
template <int N, class T>
Tensor<N, T> mid_gradient(const Tensor<N, T>& g) {
  if constexpr (N == 2) {
    // In a plane g adj(1 + g/2) = g + det(g)/2 by the theorem of Cayley and Hamilton.
    const T half = 0.5 * cross(g(0, 0), g(1, 1), g(0, 1), g(1, 0));
    const T q = 1.0 / fused(T(0.5), g(0, 0) + g(1, 1) + half, T(1.0));
    Tensor<2, T> m{};
    unroll<2>([&](auto k) { m.diagonal[k] = q * (g.diagonal[k] + half); });
    unroll<2>([&](auto k) { m.off[k] = q * g.off[k]; });
    m.diagonal[2] = g.diagonal[2] / (1.0 + 0.5 * g.diagonal[2]);
    return m;
  } else {
    return product(g, inverse(plus_diagonal(0.5 * g, 1.0)));
  }
}

template <int N, class T>
SymmetricTensor<N, T> mid_strain(const Tensor<N, T>& g) {
  return symmetric_part(mid_gradient(g));
}

/// R s R^T - s of a step whose displacement gradient at its middle is `m`, to as many digits as numbers of type T
/// have. The rotation R is exact, so that a rigid rotation by any angle below pi is one (Hughes and Winget 1980):
/// with a the axial vector of half the spin, A x = a x x, R = (1 - A)^-1 (1 + A) = 1 + 2 (A + A^2) / (1 + a.a).
template <int N, class T>
SymmetricTensor<N, T> change_by_rotation(const Tensor<N, T>& m, const SymmetricTensor<N, T>& s) {
  SymmetricTensor<N, T> change{};
  if constexpr (N == 2) {
    // Half the difference of the diagonal and the shear are a vector that turns by twice the angle, whose sine is
    // 2 a / (1 + a^2) and whose cosine 1 less a times that.
    const T a = 0.25 * (m(0, 1) - m(1, 0)), sine = 2.0 * a / fused(a, a, T(1.0)), cosine = fused(-sine, a, T(1.0));
    const T difference = 0.5 * (s(0, 0) - s(1, 1)), twice = 2.0 * sine;
    change.diagonal[0] = twice * cross(cosine, s(0, 1), sine, difference);
    change.diagonal[1] = -change.diagonal[0];
    change(0, 1) = twice * fused(-cosine, difference, -(sine * s(0, 1)));
  }
  if constexpr (N == 3) {
    const T a[] = {0.25 * (m(2, 1) - m(1, 2)), 0.25 * (m(0, 2) - m(2, 0)), 0.25 * (m(1, 0) - m(0, 1))};
    const T twice = 2.0 / fused(a[0], a[0], fused(a[1], a[1], fused(a[2], a[2], T(1.0))));
    const T b[] = {twice * a[0], twice * a[1], twice * a[2]};
    // W = R - 1 by A^2 = a a^T - a.a, then W s + (W s)^T + W s W^T.
    Tensor<3, T> w{};
    unroll<3>([&](auto i) {
      constexpr int j = (i + 1) % 3, k = (i + 2) % 3;
      w(i, i) = -fused(b[j], a[j], b[k] * a[k]);
      w(i, j) = fused(b[i], a[j], -b[k]);
      w(j, i) = fused(b[i], a[j], b[k]);
    });
    const Tensor<3, T> ws = product(w, s);
    unroll<3>([&](auto i) {
      unroll<3>([&](auto j) {
        if constexpr (i <= j)
          change(i, j) =
              fused(ws(i, 0), w(j, 0), fused(ws(i, 1), w(j, 1), fused(ws(i, 2), w(j, 2), ws(i, j) + ws(j, i))));
      });
    });
  }
  return change;
}

/// lambda tr(e) 1 + 2 mu e
template <int N, class T>
SymmetricTensor<N, T> hooke(const LameConstants& lame, const SymmetricTensor<N, T>& strain) {
  const T mean = lame.lambda * trace(strain), twice_mu = T(2 * lame.mu);
  SymmetricTensor<N, T> stress = twice_mu * strain;
  unroll<3>([&](auto k) { stress.diagonal[k] = fused(twice_mu, strain.diagonal[k], mean); });
  return stress;
}

/// What an elastic step of displacement gradient `g` adds to the Cauchy stress with the Jaumann rate. Half of what
/// the strain adds is turned with the stress that was there, for it arises while the rotation goes on: without
/// that a step's error would be of second order, not third.
template <int N, class T>
SymmetricTensor<N, T> jaumann_change(const LameConstants& lame, const Tensor<N, T>& g,
                                     const SymmetricTensor<N, T>& stress) {
  const Tensor<N, T> m = mid_gradient(g);
  const SymmetricTensor<N, T> half = hooke(LameConstants{0.5 * lame.lambda, 0.5 * lame.mu}, symmetric_part(m));
  return fused(T(2.0), half, change_by_rotation(m, stress + half));
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
