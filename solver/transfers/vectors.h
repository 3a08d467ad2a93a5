#pragma once

#include "solver/executors/instruction_set.h"

/// Short vectors of doubles.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

typedef double Pair __attribute__((vector_size(16)));
typedef double Four __attribute__((vector_size(32)));
typedef double Eight __attribute__((vector_size(64)));

template <class Vector>
__attribute__((always_inline)) inline Vector load(const double* from) {
  Vector value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}
template <class Vector>
__attribute__((always_inline)) inline void store(double* to, Vector value) {
  __builtin_memcpy(to, &value, sizeof value);
}
template <class Vector>
__attribute__((always_inline)) inline void add(double* to, Vector value) {
  store(to, load<Vector>(to) + value);
}
/// A pointer of which the compiler forgets where it comes from: it would keep the addresses of all that is read by
/// it in registers that there are not.
__attribute__((always_inline)) inline const double* hidden(const double* p) {
  asm("" : "+r"(p));
  return p;
}
__attribute__((always_inline)) inline double sum(Pair v) { return v[0] + v[1]; }
__attribute__((always_inline)) inline double sum(Four v) { return (v[0] + v[1]) + (v[2] + v[3]); }

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
