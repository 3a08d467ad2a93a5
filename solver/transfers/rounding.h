#pragma once

#include <cstdint>
#include <cstring>

#include "solver/transfers/real.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Rounds doubles to what particles carry. To floats up or down by chance, up as often as it is near: what grows
/// by less than half of its last bit in every step grows nevertheless, and steps that round are right in the mean,
/// where rounding to the nearest loses a part of each that is the same over thousands of steps (Croci, Fasi,
/// Higham, Mary and Mikaitis 2022). Chance is a hash of step, attribute and place in the block, so that bits do
/// not depend on threads.
class Rounding {
 public:
  Rounding(const Block& block, Attribute attribute)
      : seed_(0x9E3779B9U * static_cast<std::uint32_t>(block.sweep->step) +
              0x7FEB352DU * static_cast<std::uint32_t>(attribute)) {}

  __attribute__((always_inline)) Real operator()(double value, int i) const {
    if constexpr (sizeof(Real) == sizeof value) {
      return static_cast<Real>(value);
    } else {
      // A double has 29 more bits. Whatever is added to these carries as often as they say.
      constexpr std::uint64_t dropped = (1U << 29) - 1;
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      bits = (bits + (chance(static_cast<std::uint32_t>(i)) >> 3)) & ~dropped;
      std::memcpy(&value, &bits, sizeof bits);
      return static_cast<Real>(value);
    }
  }

 private:
  /// Mixes all bits of a number into the upper ones (Wellons 2018, lowbias32).
  __attribute__((always_inline)) std::uint32_t chance(std::uint32_t i) const {
    std::uint32_t x = seed_ + 0x85EBCA6BU * i;
    x ^= x >> 16;
    x *= 0x7FEB352DU;
    x ^= x >> 15;
    x *= 0x846CA68BU;
    return x;
  }

  std::uint32_t seed_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
