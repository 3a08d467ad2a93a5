#pragma once

#include <bit>
#include <cstdint>

#include "solver/materials/polynomial.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Natural logarithm of a positive normal number, to 2 units in the last place near 1 and elsewhere. Unlike
/// the library's it vectorises and has the same bits with every instruction set that rounds a product and a sum at
/// once. x = 2^k m with m in
/// [sqrt(1/2), sqrt(2)), and log m = 2 artanh(s) = 2 (s + s^3/3 + s^5/5 + ...), s = (m - 1) / (m + 1),
/// |s| < 0.1716, whose terms from s^23 on are below 2^-58 of the first.
inline double natural_logarithm(double x) {
  constexpr std::uint64_t root_half = 0x3FE6A09E667F3BCD;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const auto shifted = static_cast<std::int64_t>(bits - root_half);
  const std::int64_t exponent = shifted & static_cast<std::int64_t>(0xFFF0000000000000);
  const double m = std::bit_cast<double>(bits - static_cast<std::uint64_t>(exponent));
  // The exponent as a number without a 64-bit conversion, which older instruction sets lack: put it into
  // the mantissa of 1.5 * 2^52 and take that off again.
  constexpr std::int64_t magic = 0x4338000000000000;
  const std::int64_t biased = (shifted >> 32 >> 20) + magic;
  const double k = std::bit_cast<double>(biased) - 0x1.8p52;
  const double s = (m - 1) / (m + 1), q = s * s;
  constexpr double series[] = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11,
                               1.0 / 13, 1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21};
  const double tail = s * q * polynomial(series, q);
  return k * 0x1.62e42fefa39efp-1 + (2 * s + 2 * tail) + k * 0x1.abc9e3b39803fp-56;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
