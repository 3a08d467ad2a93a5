#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "solver/transfers/intrinsics.h"

/// Eight lanes of floats in another order, or some of them.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// values[from[lane] % 8] in each lane.
__attribute__((always_inline)) inline EightFloats permuted(EightFloats values, EightLanes from) {
  if constexpr (intrinsics::has_eight_lanes) return intrinsics::permuted(values, from);
  EightFloats result{};
  for (int lane = 0; lane < 8; ++lane) result[lane] = values[from[lane] & 7];
  return result;
}
/// values[0] .. of the lanes that have all bits; others are zero and not read.
__attribute__((always_inline)) inline EightFloats load_only(const float* values, EightLanes lanes) {
  if constexpr (intrinsics::has_eight_lanes) return intrinsics::load_masked(values, lanes);
  EightFloats result{};
  for (int lane = 0; lane < 8; ++lane)
    if (lanes[lane] != 0) result[lane] = values[lane];
  return result;
}
/// All bits of the lanes whose bit is set.
__attribute__((always_inline)) inline EightLanes lanes_of(std::int32_t bits) {
  constexpr EightLanes of_lane{1, 2, 4, 8, 16, 32, 64, 128};
  return (of_lane & bits) != 0;
}
__attribute__((always_inline)) inline bool any_bit(EightLanes v) {
  if constexpr (intrinsics::has_eight_lanes) return intrinsics::any_bit(v);
  std::int32_t bits = 0;
  for (int lane = 0; lane < 8; ++lane) bits |= v[lane];
  return bits != 0;
}
__attribute__((always_inline)) inline std::int32_t sum_of_lanes(EightLanes v) {
  v += __builtin_shufflevector(v, v, 4, 5, 6, 7, 4, 5, 6, 7);
  v += __builtin_shufflevector(v, v, 2, 3, 2, 3, 6, 7, 6, 7);
  return v[0] + v[1];
}

/// Eight bytes, the first one lowest. GCC 12 would take each by itself.
__attribute__((always_inline)) inline EightLanes lanes_of_bytes(std::uint64_t bytes) {
  if constexpr (intrinsics::has_eight_lanes) return intrinsics::lanes_of_bytes(bytes);
  EightLanes lanes{};
  for (int lane = 0; lane < 8; ++lane) lanes[lane] = static_cast<std::int32_t>(bytes >> 8 * lane & 0xFF);
  return lanes;
}

/// For each set of lanes how many of them are before each lane.
inline constexpr auto lanes_before = [] {
  std::array<std::array<std::uint8_t, 8>, 256> before{};
  for (std::uint32_t bits = 0; bits < before.size(); ++bits)
    for (std::uint32_t lane = 0; lane < 8; ++lane)
      before[bits][lane] = static_cast<std::uint8_t>(std::popcount(bits & ((1u << lane) - 1)));
  return before;
}();
__attribute__((always_inline)) inline EightLanes count_lanes_before(std::int32_t bits) {
  return lanes_of_bytes(std::bit_cast<std::uint64_t>(lanes_before[static_cast<std::size_t>(bits)]));
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
