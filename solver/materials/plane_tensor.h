#pragma once

#include "solver/executors/instruction_set.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// In-plane components of a tensor.
template <class T>
struct PlaneTensor {
  T xx, xy, yx, yy;
};

template <class T>
struct SymmetricTensor {
  T xx, yy, xy, zz;
};

template <class T>
T determinant(const PlaneTensor<T>& a) {
  return a.xx * a.yy - a.xy * a.yx;
}

template <class T>
PlaneTensor<T> product(const PlaneTensor<T>& a, const PlaneTensor<T>& b) {
  return {a.xx * b.xx + a.xy * b.yx, a.xx * b.xy + a.xy * b.yy, a.yx * b.xx + a.yy * b.yx,
          a.yx * b.xy + a.yy * b.yy};
}

template <class T>
PlaneTensor<T> inverse(const PlaneTensor<T>& a) {
  const T q = 1 / determinant(a);
  return {a.yy * q, -a.xy * q, -a.yx * q, a.xx * q};
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
