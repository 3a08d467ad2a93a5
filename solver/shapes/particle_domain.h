#pragma once

#include "solver/executors/instruction_set.h"

/// Piecewise linear functions averaged over the particle's domain, along one axis: with the node at 0 the weight
/// is (H(p + l) - H(p - l)) / (2 l), H the integral of the hat function and l the half size of the particle in
/// cells (the integral of Bardenhagen and Kober 2004 in closed form for any l).
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

struct AveragedHat {
  Real weight, slope;
};

/// Of a node that is not within the domain: p >= l.
inline AveragedHat average_outer_hat(Real p, Real half_size, Real factor) {
  const Real a = p - half_size < 1 ? p - half_size : 1, b = p + half_size < 1 ? p + half_size : 1;
  return {factor * ((b - a) * (1 - (a + b) / 2)), factor * (a - b)};
}

/// Of any node.
inline AveragedHat average_hat(Real p, Real half_size, Real factor) {
  // Written so that each is one instruction.
  const Real from = p - half_size > -1 ? p - half_size : -1, to = p + half_size > -1 ? p + half_size : -1;
  const Real a = from < 1 ? from : 1, b = to < 1 ? to : 1;
  const Real size_a = Real(__builtin_fabs(a)), size_b = Real(__builtin_fabs(b));
  return {factor * ((b - a) - (b * size_b - a * size_a) / 2), factor * (size_a - size_b)};
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
