#pragma once

#if defined(__FMA__) || defined(__AVX512VL__)
#include <immintrin.h>
#endif

#include <cstdint>
#include <type_traits>
#include <utility>

#include "solver/executors/instruction_set.h"

/// What compilers do not find by themselves: in kernels this file, eight_lanes.h, find_ends.h and masks.h alone
/// name instructions. Each function says in plain code what it does; where the instruction set has nothing for it,
/// that is what runs.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// So many numbers.
template <class Number, std::size_t count>
struct VectorOf {
  // GCC 12 forgets such an attribute of an alias.
  typedef Number Type __attribute__((vector_size(count * sizeof(Number))));  // NOLINT(modernize-use-using)
};

namespace intrinsics {
#ifdef __FMA__
__attribute__((always_inline)) inline float fused(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
__attribute__((always_inline)) inline double fused(double a, double b, double c) { return __builtin_fma(a, b, c); }
__attribute__((always_inline)) inline __m128d fused(__m128d a, __m128d b, __m128d c) {
  return _mm_fmadd_pd(a, b, c);
}
__attribute__((always_inline)) inline __m256d fused(__m256d a, __m256d b, __m256d c) {
  return _mm256_fmadd_pd(a, b, c);
}
__attribute__((always_inline)) inline __m128 fused(__m128 a, __m128 b, __m128 c) { return _mm_fmadd_ps(a, b, c); }
__attribute__((always_inline)) inline __m256 fused(__m256 a, __m256 b, __m256 c) {
  return _mm256_fmadd_ps(a, b, c);
}
__attribute__((always_inline)) inline __m256d widened(__m128 a) { return _mm256_cvtps_pd(a); }
#endif
#ifdef __AVX512F__
__attribute__((always_inline)) inline __m512d fused(__m512d a, __m512d b, __m512d c) {
  return _mm512_fmadd_pd(a, b, c);
}
__attribute__((always_inline)) inline __m512 fused(__m512 a, __m512 b, __m512 c) {
  return _mm512_fmadd_ps(a, b, c);
}
__attribute__((always_inline)) inline __m512d widened(__m256 a) {
  return _mm512_maskz_cvtps_pd(0xFF, a);  // the form without a mask makes GCC 12 warn of its own header
}
#endif
void fused(), widened();  // so that the names are there
}  // namespace intrinsics

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

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
