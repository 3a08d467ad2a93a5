#pragma once

#include "solver/materials/dual.h"
#include "solver/materials/exponential.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <int K>
Dual<K> exponential(const Dual<K>& a) {
  const double value = exponential(a.value);
  return chain(a, value, value);
}

/// The logarithm of a^exponent for a > 0; what is less, 0 too, counts as 2^-1000.
template <class T>
T log_power(const T& a, double exponent) {
  return exponent * natural_logarithm(choose(a > T(0x1p-1000), a, T(0x1p-1000)));
}
template <class T>
T power(const T& a, double exponent) {
  return exponential(log_power(a, exponent));
}

template <class T>
T larger(const T& a, const T& b) {
  return choose(a > b, a, b);
}
template <class T>
T smaller(const T& a, const T& b) {
  return choose(a < b, a, b);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
