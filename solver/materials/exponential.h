#pragma once

#include <bit>
#include <cstdint>

#include "solver/materials/polynomial.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// e^x to 2 units in the last place; below -708 it stays what it is there, and above 709 likewise, so that it
/// is always a positive normal number. Unlike the library's it vectorises and has the same bits with
/// every instruction set that rounds a product and a sum at once. x = k ln 2 + r with |r| <= ln(2) / 2, and the
/// Taylor series of e^r, whose terms from r^14 on are below 2^-57.
inline double exponential(double x) {
  x = x < -708.0 ? -708.0 : x;
  x = x > 709.0 ? 709.0 : x;
  // e^x is 1 to rounding. Products of much smaller numbers are denormal, which take a processor a hundred cycles
  // each: without this Weibull damage far below the strength takes 138 ns per particle and step, with it 72.
  x = x > -0x1p-60 && x < 0x1p-60 ? 0.0 : x;
  // Adding 1.5 * 2^52 rounds to an integer, which is then found in the mantissa's last bits.
  constexpr double magic = 0x1.8p52;
  const double shifted = x * 0x1.71547652b82fep0 + magic;
  const double k = shifted - magic;
  const double r = (x - k * 0x1.62e42fefa0000p-1) - k * 0x1.cf79abc9e3b3ap-40;
  constexpr double taylor[] = {1.0 / 2,       1.0 / 6,        1.0 / 24,        1.0 / 120,
                               1.0 / 720,     1.0 / 5040,     1.0 / 40320,     1.0 / 362880,
                               1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  const double power = 1 + fused(r * r, polynomial(taylor, r), r);
  // Times 2^k, by way of the exponent's bits.
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(power) + (std::bit_cast<std::uint64_t>(shifted) << 52);
  return std::bit_cast<double>(bits);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
