#pragma once

#include "solver/transfers/eight_lanes.h"

/// Where sequences of numbers end.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Where numbers change.
struct Changes {
  template <class Number>
  static auto is_end(Number before, Number now) {
    return now != before;
  }
};

/// Where numbers of `row` rows of as many do not grow, or come to another row.
template <std::int32_t row>
struct RiseEnds {
  template <class Number>
  static auto is_end(Number before, Number now) {
    return (now <= before) | (row_of(now) != row_of(before));
  }
  template <class Number>
  static Number row_of(Number number) {
    return number * factor >> 16;
  }
  static constexpr std::int32_t factor = (1 << 16) / row + 1;
  static_assert((row * row - 1) * factor >> 16 == row - 1 && row * (row - 1) * factor >> 16 == row - 1);
};

#if defined(__AVX512F__) && defined(__AVX512DQ__)
using SixteenLanes = VectorOf<std::int32_t, 16>::Type;
#endif

/// Writes the indices i in 1 .. count - 1 for which At::is_end(values[i - 1], values[i]), in order, and returns
/// how many there are. Without a branch that depends on the values, and with room for 16 indices more. Each number
/// is read once: what has just been written and is then read from another address has to wait for the cache.
template <class At>
inline int find_ends(const std::int32_t* values, int count, std::int32_t* out) {
  int found = 0;
#if defined(__AVX512F__) && defined(__AVX512DQ__)
  SixteenLanes index{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  auto last = SixteenLanes{} + values[0];
  for (int i = 0; i < count; i += 16, index += 16) {
    const auto there = static_cast<__mmask16>(count - i < 16 ? (1 << (count - i)) - 1 : 0xFFFF);
    const auto now = reinterpret_cast<SixteenLanes>(_mm512_maskz_loadu_epi32(there, values + i));
    const SixteenLanes before =
        __builtin_shufflevector(last, now, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30);
    const auto after_the_first = static_cast<__mmask16>(i > 0 ? there : there & ~1);
    const auto ends = static_cast<__mmask16>(
        _mm512_movepi32_mask(reinterpret_cast<__m512i>(At::is_end(before, now))) & after_the_first);
    _mm512_storeu_si512(out + found, _mm512_maskz_compress_epi32(ends, reinterpret_cast<__m512i>(index)));
    found += __builtin_popcount(ends);
    last = now;
  }
#elif defined(__AVX2__) && defined(__BMI2__)
  auto last = EightLanes{} + values[0];
  for (int i = 0; i < count; i += 8) {
    const std::int32_t bits = count - i < 8 ? (1 << (count - i)) - 1 : 0xFF;
    const auto now =
        reinterpret_cast<EightLanes>(_mm256_maskload_epi32(values + i, reinterpret_cast<__m256i>(lanes_of(bits))));
    const EightLanes before = __builtin_shufflevector(last, now, 7, 8, 9, 10, 11, 12, 13, 14);
    const int after_the_first = i > 0 ? bits : bits & ~1;
    const auto ends = static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(At::is_end(before, now))) &
                                            after_the_first);
    // The numbers of the lanes that are set, one a byte.
    const std::uint64_t bytes = _pdep_u64(ends, 0x0101010101010101U) * 0xFF;
    const EightLanes indices = lanes_of_bytes(_pext_u64(0x0706050403020100U, bytes)) + i;
    __builtin_memcpy(out + found, &indices, sizeof indices);
    found += __builtin_popcount(ends);
    last = now;
  }
#else
  for (int i = 1; i < count; ++i) {
    out[found] = i;
    found += At::is_end(values[i - 1], values[i]);
  }
#endif
  return found;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
