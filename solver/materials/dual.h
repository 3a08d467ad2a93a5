#pragma once

#include <cmath>
#include <compare>

#include "solver/materials/logarithm.h"
#include "solver/materials/unroll.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// A number with its derivatives by K variables, which all operations carry along (forward mode of automatic
/// differentiation; Griewank and Walther 2008, section 3.1). Comparisons look at the value alone.
template <int K>
struct Dual {
  double value;
  double slope[K];

  constexpr Dual() : value(0), slope{} {}
  constexpr Dual(double constant) : value(constant), slope{} {}
  /// The variable of this index.
  constexpr Dual(double at, int variable) : value(at), slope{} { slope[variable] = 1; }

  constexpr auto operator<=>(const Dual& b) const { return value <=> b.value; }
  constexpr bool operator==(const Dual& b) const { return value == b.value; }
};

/// f(a), when f is `value` and its derivative `derivative` there.
template <int K>
constexpr Dual<K> chain(const Dual<K>& a, double value, double derivative) {
  Dual<K> r(value);
  unroll<K>([&](auto k) { r.slope[k] = derivative * a.slope[k]; });
  return r;
}

template <int K>
constexpr Dual<K> operator-(const Dual<K>& a) {
  return chain(a, -a.value, -1);
}
template <int K>
constexpr Dual<K> operator+(const Dual<K>& a, const Dual<K>& b) {
  Dual<K> r(a.value + b.value);
  unroll<K>([&](auto k) { r.slope[k] = a.slope[k] + b.slope[k]; });
  return r;
}
template <int K>
constexpr Dual<K> operator-(const Dual<K>& a, const Dual<K>& b) {
  Dual<K> r(a.value - b.value);
  unroll<K>([&](auto k) { r.slope[k] = a.slope[k] - b.slope[k]; });
  return r;
}
template <int K>
constexpr Dual<K> operator*(const Dual<K>& a, const Dual<K>& b) {
  Dual<K> r(a.value * b.value);
  unroll<K>([&](auto k) { r.slope[k] = a.slope[k] * b.value + a.value * b.slope[k]; });
  return r;
}
template <int K>
constexpr Dual<K> operator/(double a, const Dual<K>& b) {
  const double q = 1 / b.value;
  return chain(b, a * q, -(a * q) * q);
}
template <int K>
constexpr Dual<K> operator/(const Dual<K>& a, const Dual<K>& b) {
  return a * (1.0 / b);
}

template <int K>
constexpr Dual<K> operator+(const Dual<K>& a, double b) {
  return chain(a, a.value + b, 1);
}
template <int K>
constexpr Dual<K> operator+(double a, const Dual<K>& b) {
  return b + a;
}
template <int K>
constexpr Dual<K> operator-(const Dual<K>& a, double b) {
  return chain(a, a.value - b, 1);
}
template <int K>
constexpr Dual<K> operator-(double a, const Dual<K>& b) {
  return chain(b, a - b.value, -1);
}
template <int K>
constexpr Dual<K> operator*(const Dual<K>& a, double b) {
  return chain(a, a.value * b, b);
}
template <int K>
constexpr Dual<K> operator*(double a, const Dual<K>& b) {
  return b * a;
}
template <int K>
constexpr Dual<K> operator/(const Dual<K>& a, double b) {
  return a * (1 / b);
}

template <int K>
Dual<K> natural_logarithm(const Dual<K>& a) {
  return chain(a, natural_logarithm(a.value), 1 / a.value);
}
inline double square_root(double a) { return std::sqrt(a); }
/// At 0 the derivative is taken to be 0.
template <int K>
Dual<K> square_root(const Dual<K>& a) {
  const double root = std::sqrt(a.value);
  return chain(a, root, root > 0 ? 0.5 / root : 0);
}

/// condition ? a : b, without a branch that would keep loops from being vectorised.
template <class T>
constexpr T choose(bool condition, const T& a, const T& b) {
  return condition ? a : b;
}
template <int K>
constexpr Dual<K> choose(bool condition, const Dual<K>& a, const Dual<K>& b) {
  Dual<K> r(condition ? a.value : b.value);
  unroll<K>([&](auto k) { r.slope[k] = condition ? a.slope[k] : b.slope[k]; });
  return r;
}

/// The number without its derivatives.
constexpr double value_of(double a) { return a; }
template <int K>
constexpr double value_of(const Dual<K>& a) {
  return a.value;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
