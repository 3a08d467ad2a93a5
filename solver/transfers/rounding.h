#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "solver/executors/block.h"
#include "solver/executors/instruction_set.h"
#include "solver/transfers/registers.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Multiples of the fractional part of an irrational number, in 2^-32, by the place in a block: to read one takes
/// an instruction where to find it takes four.
inline constexpr auto shares_of_places = [] {
  std::array<std::uint32_t, block_size + block_padding> shares{};
  for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = 0x91E10DA5U * static_cast<std::uint32_t>(i);
  return shares;
}();

/// Rounds doubles to what particles carry. To floats up or down, up as often as it is near: what grows by less
/// than half of its last bit in every step grows nevertheless, and steps that round are right in the mean, where
/// rounding to the nearest loses a part of each that is the same over thousands of steps (Croci, Fasi, Higham,
/// Mary and Mikaitis 2022). Which of them it is to be follows from multiples of two irrational numbers, by the
/// step and by the place in the block: they fill the unit interval more evenly than chance would (Weyl 1916; these
/// two do so in the plane, Roberts 2018), and do not depend on threads.
template <class Number>
class RoundingTo {
 public:
  RoundingTo(const Block& block, Attribute attribute)
      : first_(0xC13FA9A9U * static_cast<std::uint32_t>(block.sweep->step) +
               0x7FEB352DU * static_cast<std::uint32_t>(attribute)) {}

  __attribute__((always_inline)) Number operator()(double value, int i) const {
    if constexpr (sizeof(Number) == sizeof value) {
      return value;
    } else {
      // A double has 29 more bits. Whatever is added to these carries as often as they say.
      constexpr std::uint64_t dropped = (1U << 29) - 1;
      const std::uint64_t bits = std::bit_cast<std::uint64_t>(value) + (share(i) >> 3);
      return static_cast<Number>(std::bit_cast<double>(bits & ~dropped));
    }
  }

  /// value + change, of which the latter is the smaller.
  __attribute__((always_inline)) Number add(Number value, Number change, int i) const {
    if constexpr (std::is_same_v<Number, double>) {
      return value + change;
    } else {
      // Rounded to the nearest of what has been moved by up to half of the last bit of the value.
      constexpr std::uint32_t exponent = 0x7F800000;
      const auto power = std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) & exponent);
      const float moved = 0x1p-55F * static_cast<float>(static_cast<std::int32_t>(share(i)));
      return value + multiply_add(power, moved, change);
    }
  }

 private:
  /// Of the unit interval, in 2^-32.
  __attribute__((always_inline)) std::uint32_t share(int i) const {
    return first_ + shares_of_places[static_cast<std::size_t>(i)];
  }

  std::uint32_t first_;
};
using Rounding = RoundingTo<Real>;

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
