#pragma once

#if defined(__FMA__) || defined(__AVX2__)
#include <immintrin.h>
#endif

#include <cstddef>
#include <cstdint>

#include "solver/executors/instruction_set.h"

/// What compilers do not find by themselves: in kernels this file alone names instructions. Who calls a function
/// of `intrinsics` says in plain code what it does; where the instruction set has nothing for it, that is what
/// runs.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// So many numbers.
template <class Number, std::size_t count>
struct VectorOf {
  // GCC 12 forgets such an attribute of an alias.
  typedef Number Type __attribute__((vector_size(count * sizeof(Number))));  // NOLINT(modernize-use-using)
};
using EightLanes = VectorOf<std::int32_t, 8>::Type;
using EightFloats = VectorOf<float, 8>::Type;

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
__attribute__((always_inline)) inline void load_masked(const double* from, long long mask, __m512d& into) {
  into = _mm512_maskz_loadu_pd(static_cast<__mmask8>(mask), from);
}
#endif
#ifdef __AVX2__
inline constexpr bool has_eight_lanes = true;
__attribute__((always_inline)) inline void load_masked(const double* from, long long mask, __m256d& into) {
  const auto bit = [mask](int lane) { return -(mask >> lane & 1); };
  into = _mm256_maskload_pd(from, _mm256_setr_epi64x(bit(0), bit(1), bit(2), bit(3)));
}
__attribute__((always_inline)) inline EightFloats load_masked(const float* from, EightLanes lanes) {
  return _mm256_maskload_ps(from, reinterpret_cast<__m256i>(lanes));
}
__attribute__((always_inline)) inline EightFloats permuted(EightFloats values, EightLanes from) {
  return _mm256_permutevar8x32_ps(values, reinterpret_cast<__m256i>(from));
}
__attribute__((always_inline)) inline bool any_bit(EightLanes v) {
  return !_mm256_testz_si256(reinterpret_cast<__m256i>(v), reinterpret_cast<__m256i>(v));
}
__attribute__((always_inline)) inline EightLanes lanes_of_bytes(std::uint64_t bytes) {
  return reinterpret_cast<EightLanes>(_mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<std::int64_t>(bytes))));
}
#else
inline constexpr bool has_eight_lanes = false;
// Named where they are not called.
EightFloats load_masked(const float*, EightLanes), permuted(EightFloats, EightLanes);
bool any_bit(EightLanes);
EightLanes lanes_of_bytes(std::uint64_t);
#endif

/// \name As many numbers as a register has room for
/// Each of `bits` stands for one of them.
/// @{
#if defined(__AVX512F__) && defined(__AVX512DQ__)
inline constexpr bool has_places = true;
using Places = VectorOf<std::int32_t, 16>::Type;
/// Zero where there is no bit, and what would be there is not read.
__attribute__((always_inline)) inline Places load_places(const std::int32_t* from, unsigned bits) {
  return reinterpret_cast<Places>(_mm512_maskz_loadu_epi32(static_cast<__mmask16>(bits), from));
}
__attribute__((always_inline)) inline unsigned negative_places(Places of) {
  return _mm512_movepi32_mask(reinterpret_cast<__m512i>(of));
}
/// Puts first + place of all bits one after the other. Others are overwritten up to a register's end.
__attribute__((always_inline)) inline void store_places(std::int32_t* to, unsigned bits, std::int32_t first) {
  const Places places = Places{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15} + first;
  _mm512_storeu_si512(
      to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), reinterpret_cast<__m512i>(places)));
}
#else
using Places = EightLanes;
#if defined(__AVX2__) && defined(__BMI2__)
inline constexpr bool has_places = true;
__attribute__((always_inline)) inline Places load_places(const std::int32_t* from, unsigned bits) {
  const Places there = (Places{1, 2, 4, 8, 16, 32, 64, 128} & static_cast<std::int32_t>(bits)) != 0;
  return reinterpret_cast<Places>(_mm256_maskload_epi32(from, reinterpret_cast<__m256i>(there)));
}
__attribute__((always_inline)) inline unsigned negative_places(Places of) {
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(of)));
}
__attribute__((always_inline)) inline void store_places(std::int32_t* to, unsigned bits, std::int32_t first) {
  // The places, one a byte.
  const std::uint64_t bytes = _pdep_u64(bits, 0x0101010101010101U) * 0xFF;
  const Places places = lanes_of_bytes(_pext_u64(0x0706050403020100U, bytes)) + first;
  __builtin_memcpy(to, &places, sizeof places);
}
#else
inline constexpr bool has_places = false;
// Named where they are not called.
Places load_places(const std::int32_t*, unsigned);
unsigned negative_places(Places);
void store_places(std::int32_t*, unsigned, std::int32_t);
#endif
#endif
/// @}

void fused(), widened(), load_masked();  // so that the names are there
}  // namespace intrinsics

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
