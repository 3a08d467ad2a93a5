#pragma once

#include "solver/materials/free_rest.h"
#include "solver/schemes/law_particles.h"

/// One particle's way through a finite step of displacement gradient G (solver/schemes/law_response.h), from the
/// state at its beginning. Where the rest is free of stress, the rest of G is what has been found for it.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// What steps of all laws have in common.
template <int N, bool TotalLagrangian>
struct StepKinematics {
  Tensor<N> start;  ///< F at the beginning

  template <class T>
  Tensor<N, T> end(const Tensor<N, T>& g) const {
    const Tensor<N, T> f = cast<T>(start);
    return TotalLagrangian ? f + g : f + product(g, f);
  }
  /// The work of a Kirchhoff stress per component of G.
  template <class T>
  Tensor<N, T> nominal(const SymmetricTensor<N, T>& kirchhoff, const Tensor<N, T>& g) const {
    const Tensor<N, T> carried = cast<T>(TotalLagrangian ? start : identity<N>()) + g;
    return product_transposed(full(kirchhoff), inverse(carried));
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
