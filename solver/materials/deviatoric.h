#pragma once

#include "solver/materials/dual.h"
#include "solver/materials/tensor_products.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// A stress cut into its deviator and its mean.
template <int N, class T>
struct SplitStress {
  SymmetricTensor<N, T> deviator;
  T mean;
  explicit SplitStress(const SymmetricTensor<N, T>& stress)
      : deviator(trajan::deviator(stress)), mean(trace(stress) * (1.0 / 3)) {}

  /// Half the square of the deviator, J_2.
  T second_invariant() const { return 0.5 * double_contraction(deviator, deviator); }
  /// sqrt(3 J_2), which in uniaxial tension is the stress (von Mises 1913).
  T equivalent() const { return square_root(3.0 * second_invariant()); }
  /// The stress whose deviator is this one times `share`.
  SymmetricTensor<N, T> with(const T& share, const T& new_mean) const {
    return plus_diagonal(share * deviator, new_mean);
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
