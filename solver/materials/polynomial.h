#pragma once

#include <bit>

#include "solver/materials/fused.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// c[0] + c[1] x + ... + c[Count - 1] x^(Count - 1), of the powers x, x^2, x^4, x^8, by Estrin (1960): halves at
/// once, where Horner's rule waits for every term.
template <unsigned Count>
inline double polynomial(const double* c, const double* powers) {
  if constexpr (Count == 1) {
    return c[0];
  } else {
    constexpr unsigned lower = std::bit_ceil(Count) / 2;
    return fused(polynomial<Count - lower>(c + lower, powers), powers[std::countr_zero(lower)],
                 polynomial<lower>(c, powers));
  }
}

/// The same of x.
template <unsigned Count>
inline double polynomial(const double (&c)[Count], double x) {
  static_assert(Count <= 16);
  const double square = x * x, fourth = square * square;
  const double powers[] = {x, square, fourth, fourth * fourth};
  return polynomial<Count>(&c[0], powers);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
