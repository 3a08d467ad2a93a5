#pragma once

#include <bit>
#include <concepts>
#include <cstdint>

#include "solver/materials/fused.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// A float that stays one in formulas whose constants are doubles, as those of laws are.
struct Single {
  float value = 0;

  constexpr Single() = default;
  constexpr Single(double constant) : value(static_cast<float>(constant)) {}
  template <std::same_as<float> Float>
  constexpr explicit Single(Float number) : value(number) {}

  friend constexpr Single operator-(Single a) { return Single(-a.value); }
  friend constexpr Single operator+(Single a, Single b) { return Single(a.value + b.value); }
  friend constexpr Single operator-(Single a, Single b) { return Single(a.value - b.value); }
  friend constexpr Single operator*(Single a, Single b) { return Single(a.value * b.value); }
  friend constexpr Single operator/(Single a, Single b) { return Single(a.value / b.value); }
};

inline Single fused(Single a, Single b, Single c) { return Single(fused(a.value, b.value, c.value)); }

/// log(1 + x) of x > -1, to 3 units in the last place: as natural_logarithm of a double, but that the numerator
/// gets back what 1 + x has lost of x. Terms of the series from s^11 on are below 2^-28 of the first.
inline Single logarithm_of_one_more(Single x) {
  constexpr std::uint32_t root_half = 0x3F3504F3, one = 0x3F800000;
  const float sum = 1 + x.value, lost = x.value - (sum - 1);
  const std::int32_t exponent = static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(sum) - root_half) >> 23;
  const float scale = std::bit_cast<float>(one - (static_cast<std::uint32_t>(exponent) << 23)), m = scale * sum;
  const float s = fused(scale, lost, m - 1) / (m + 1), q = s * s;
  const float tail = fused(q, fused(q, fused(q, 1.0F / 9, 1.0F / 7), 1.0F / 5), 1.0F / 3);
  return Single(fused(static_cast<float>(exponent), 0x1.62e430p-1F, 2 * fused(s * q, tail, s)));
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
