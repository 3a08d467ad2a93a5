#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "solver/transfers/registers.h"

/// Short vectors of numbers.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

using Pair = VectorOf<Real, 2>::Type;
using Four = VectorOf<Real, 4>::Type;
using Eight = Numbers<Real, 8>;

template <class Number, class Value>
__attribute__((always_inline)) inline auto converted(Value value) {
  if constexpr (std::is_arithmetic_v<Value>) {
    return static_cast<Number>(value);
  } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value[0])>, Number>) {
    return value;
  } else if constexpr (is_twice<Numbers<Number, sizeof value / sizeof value[0]>>) {
    using Wide = Numbers<Number, sizeof value / sizeof value[0]>;
    return [&]<std::size_t... lane>(std::index_sequence<lane...>) __attribute__((always_inline)) {
      return Wide{converted_vector<decltype(Wide::lower)>(__builtin_shufflevector(value, value, lane...)),
                  converted_vector<decltype(Wide::upper)>(
                      __builtin_shufflevector(value, value, (lane + sizeof...(lane))...))};
    }
    (std::make_index_sequence<Wide::half>());
  } else {
    constexpr std::size_t count = sizeof value / sizeof value[0];
    return converted_vector<typename VectorOf<Number, count>::Type>(value);
  }
}
template <class Vector, class Number>
__attribute__((always_inline)) inline Vector load(const Number* from) {
  if constexpr (is_twice<Vector>) {
    using Half = decltype(Vector::lower);
    return {load<Half>(from), load<Half>(from + Vector::half)};
  } else {
    Vector value;
    __builtin_memcpy(&value, from, sizeof value);
    return value;
  }
}
/// Of numbers of any type, scalars too, which become those of the array.
template <class Number, class Value>
__attribute__((always_inline)) inline void store(Number* to, Value value) {
  if constexpr (is_twice<Value>) {
    store(to, value.lower);
    store(to + Value::half, value.upper);
  } else {
    const auto as_number = converted<Number>(value);
    __builtin_memcpy(to, &as_number, sizeof as_number);
  }
}
template <class Number, class Value>
__attribute__((always_inline)) inline void add(Number* to, Value value) {
  const auto as_number = converted<Number>(value);
  store(to, load<std::remove_const_t<decltype(as_number)>>(to) + as_number);
}
/// The same number in all lanes.
template <class Vector, class Number>
__attribute__((always_inline)) inline Vector spread(Number number) {
  return number - Vector{};
}
/// Consecutive particles, from one on.
template <class Lanes>
struct Consecutive {
  __attribute__((always_inline)) Lanes load(const Real* values) const {
    return trajan::load<Lanes>(values + first);
  }
  int first;
};

/// A pointer of which the compiler forgets where it comes from: it would keep the addresses of all that is read by
/// it in registers that there are not.
__attribute__((always_inline)) inline const Real* hidden(const Real* p) {
  asm("" : "+r"(p));
  return p;
}
/// Of the lanes 0 and 1, 2 and 3, 4 and 5, 6 and 7.
__attribute__((always_inline)) inline Four sum_of_pairs(VectorOf<Real, 8>::Type v) {
  return __builtin_shufflevector(v, v, 0, 2, 4, 6) + __builtin_shufflevector(v, v, 1, 3, 5, 7);
}
__attribute__((always_inline)) inline Real sum(Pair v) { return v[0] + v[1]; }
__attribute__((always_inline)) inline Real sum(Four v) { return (v[0] + v[1]) + (v[2] + v[3]); }

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
