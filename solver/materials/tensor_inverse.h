#pragma once

#include "solver/materials/tensor.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// a b - c d
template <class T>
constexpr T cross(const T& a, const T& b, const T& c, const T& d) {
  return fused(a, b, -(c * d));
}

template <AnyTensor A>
constexpr typename A::Scalar determinant(const A& a) {
  const auto& d = a.diagonal;
  if constexpr (A::size == 1) return d[0] * d[1] * d[2];
  if constexpr (A::size == 2) return cross(d[0], d[1], a(0, 1), a(1, 0)) * d[2];
  if constexpr (A::size == 3)
    return fused(
        d[0], cross(d[1], d[2], a(1, 2), a(2, 1)),
        cross(a(0, 2), cross(a(1, 0), a(2, 1), d[1], a(2, 0)), a(0, 1), cross(a(1, 0), d[2], a(1, 2), a(2, 0))));
}

/// det(1 + a) - 1, without the loss of digits that taking off 1 from the determinant of what is near it has.
template <AnyTensor A>
constexpr typename A::Scalar dilation(const A& a) {
  using T = typename A::Scalar;
  const auto& d = a.diagonal;
  const auto joined = [](const T& x, const T& y) { return fused(x, y, x + y); };
  if constexpr (A::size < 3) {
    T plane = joined(d[0], d[1]);
    if constexpr (A::size == 2) plane = fused(-a(0, 1), a(1, 0), plane);
    return joined(plane, d[2]);
  } else {
    // Trace, second invariant and determinant.
    return trace(a) + (cross(d[0], d[1], a(0, 1), a(1, 0)) + cross(d[1], d[2], a(1, 2), a(2, 1)) +
                       cross(d[0], d[2], a(0, 2), a(2, 0)) + determinant(a));
  }
}

template <AnyTensor A>
constexpr A inverse(const A& a) {
  using T = typename A::Scalar;
  const auto& d = a.diagonal;
  A r{};
  if constexpr (A::size == 3) {
    const T q = 1.0 / determinant(a);
    // Cofactors by cyclic indices, transposed.
    unroll<3>([&](auto i) {
      unroll<3>([&](auto j) {
        constexpr int k = (i + 1) % 3, l = (i + 2) % 3, m = (j + 1) % 3, n = (j + 2) % 3;
        r(j, i) = q * cross(a(k, m), a(l, n), a(k, n), a(l, m));
      });
    });
  } else if constexpr (A::size == 2) {
    const T q = 1.0 / cross(d[0], d[1], a(0, 1), a(1, 0));
    r.diagonal[0] = q * d[1];
    r.diagonal[1] = q * d[0];
    r.diagonal[2] = 1.0 / d[2];
    unroll<A::off_count>([&](auto k) { r.off[k] = -(q * a.off[k]); });
  } else {
    unroll<3>([&](auto k) { r.diagonal[k] = 1.0 / d[k]; });
  }
  return r;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
