#pragma once

#include <cstddef>
#include <type_traits>

#include "solver/transfers/intrinsics.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// A vector that is twice as wide as registers. GCC 12 has such ones as well, but puts each through memory, a
/// quarter of it at a time, and waits for it: without AVX-512 a step by MUSL took 51 instead of 39 ns in a plane
/// and 103 instead of 59 ns in space (Zen 3, fastest series).
template <class Half>
struct Twice {
  using Number = std::remove_cvref_t<decltype(std::declval<Half&>()[0])>;
  static constexpr int half = sizeof(Half) / sizeof(Number);

  __attribute__((always_inline)) Number operator[](int lane) const {
    return lane < half ? lower[lane] : upper[lane - half];
  }
  __attribute__((always_inline)) friend Twice operator+(Twice a, Twice b) {
    return {a.lower + b.lower, a.upper + b.upper};
  }
  __attribute__((always_inline)) friend Twice operator*(Twice a, Twice b) {
    return {a.lower * b.lower, a.upper * b.upper};
  }
  __attribute__((always_inline)) friend Twice operator*(Twice a, Number b) { return {a.lower * b, a.upper * b}; }
  __attribute__((always_inline)) friend Twice operator*(Number a, Twice b) { return b * a; }
  __attribute__((always_inline)) friend Twice operator-(Number a, Twice b) { return {a - b.lower, a - b.upper}; }
  __attribute__((always_inline)) Twice operator-() const { return {-lower, -upper}; }
  __attribute__((always_inline)) Twice& operator+=(Twice b) { return *this = *this + b; }
  __attribute__((always_inline)) Twice& operator*=(Twice b) { return *this = *this * b; }

  Half lower, upper;
};

/// So many numbers, in one register or in two.
#ifdef __AVX512F__
inline constexpr std::size_t register_bytes = 64;
#else
inline constexpr std::size_t register_bytes = 32;
#endif
template <class Number, std::size_t count>
using Numbers =
    std::conditional_t<count * sizeof(Number) <= register_bytes, typename VectorOf<Number, count>::Type,
                       Twice<typename VectorOf<Number, count / 2>::Type>>;
template <class Vector>
inline constexpr bool is_twice = false;
template <class Half>
inline constexpr bool is_twice<Twice<Half>> = true;

template <class Half>
__attribute__((always_inline)) inline Twice<Half> multiply_add(Twice<Half> a, Twice<Half> b, Twice<Half> c) {
  return {multiply_add(a.lower, b.lower, c.lower), multiply_add(a.upper, b.upper, c.upper)};
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
