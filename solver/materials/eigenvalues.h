#pragma once

#include <array>

#include "solver/materials/dual.h"
#include "solver/materials/tensor.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Makes component (p, q) zero by a rotation in that plane (Jacobi; Golub and Van Loan 2013, section 8.5).
template <class T>
void rotate_away(SymmetricTensor<3, T>& a, int p, int q) {
  const int r = 3 - p - q;
  const T off = a(p, q), half = 0.5 * (a(q, q) - a(p, p));
  const T root = square_root(half * half + off * off);
  const T magnitude = choose(half < T(0.0), root - half, root + half);
  // The tangent of the smaller of the two angles; 0 where there is nothing to rotate away.
  const T t = choose(magnitude > T(0.0),
                     choose(half < T(0.0), -off, off) / choose(magnitude > T(0.0), magnitude, T(1.0)), T(0.0));
  const T c = 1.0 / square_root(1.0 + t * t), s = t * c;
  a(p, p) = a(p, p) - t * off;
  a(q, q) = a(q, q) + t * off;
  a(p, q) = T(0.0);
  const T pr = a(p, r), qr = a(q, r);
  a(p, r) = c * pr - s * qr;
  a(q, r) = s * pr + c * qr;
}

/// Principal values, in no order; those of the rest stay in their places.
template <int N, class T>
std::array<T, 3> eigenvalues(SymmetricTensor<N, T> a) {
  if constexpr (N == 2) {
    const T mean = 0.5 * (a.diagonal[0] + a.diagonal[1]), half = 0.5 * (a.diagonal[0] - a.diagonal[1]);
    const T radius = square_root(half * half + a.off[0] * a.off[0]);
    return {mean + radius, mean - radius, a.diagonal[2]};
  }
  if constexpr (N == 3) {
    // Convergence is quadratic in the end; five rounds reach rounding from any start.
    unroll<5>([&](auto) {
      rotate_away(a, 0, 1);
      rotate_away(a, 0, 2);
      rotate_away(a, 1, 2);
    });
  }
  return {a.diagonal[0], a.diagonal[1], a.diagonal[2]};
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
