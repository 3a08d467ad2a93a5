#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "solver/transfers/intrinsics.h"

/// Numbers in one register or in two.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// a b + c, rounded once where the instruction set has an instruction for that, which x86-64-v3 has, v4 too, and
/// v2 has not: of numbers and of vectors. It takes 20 to 30 % off scatters and gathers: in a plane with linear
/// functions 11.1 -> 8.5 ns per particle and step.
template <class Vector>
__attribute__((always_inline)) inline Vector multiply_add(Vector a, Vector b, Vector c) {
  if constexpr (requires { intrinsics::fused(a, b, c); }) {
    return intrinsics::fused(a, b, c);
  } else {
    return a * b + c;
  }
}

/// A vector's numbers as others. Of floats GCC 12 would widen each half of a register by itself: in a plane with
/// linear functions 0.7 ns more per particle and step.
template <class To, class Vector>
__attribute__((always_inline)) inline To converted_vector(Vector value) {
  if constexpr (requires { To(intrinsics::widened(value)); })
    return intrinsics::widened(value);
  else
    return __builtin_convertvector(value, To);
}

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

#ifdef __AVX512VL__
inline constexpr std::size_t register_bytes = 64, register_count = 32;
#else
inline constexpr std::size_t register_bytes = 32, register_count = 16;
#endif
/// So many numbers, in one register or in two.
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
