#pragma once

#include <span>

#include "solver/materials/wave_modulus.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The acoustic tensor at rest for waves along a grid axis: the traction on a plane normal to it by the gradient
/// of displacement along it, N x N row by row. Its eigenvalues are density times squares of wave speeds (Ogden
/// 1997, section 6.3.2). Rest stresses of plane stress and bars stay zero.
template <Dimension D, AnyLaw Law>
void acoustic_tensor_at_rest(const Law& law, int axis, std::span<double> out) {
  constexpr int N = grid_axes(D), K = rest_is_free(D) ? 3 : N;
  if constexpr (Law::rate_form) {
    const LameConstants moduli =
        law.moduli(RateState<N, double, history_count<Law>()>{{}, 1, initial_history(law, 0)});
    for (int i = 0; i < N * N; ++i)
      out[i] = i / N != i % N ? 0.0 : i / N == axis ? moduli.wave_modulus(D) : moduli.mu;
  } else {
    using T = Dual<K>;
    Tensor<N, T> f = identity<N, T>();
    for (int i = 0; i < N; ++i) f(i, axis) = T(i == axis ? 1.0 : 0.0, i);
    for (int r = N; r < K; ++r) f.diagonal[r] = T(1.0, r);
    HistoryOf<Law, T> history{};
    const HistoryOf<Law> initial = initial_history(law, 0);
    std::copy(initial.begin(), initial.end(), history.begin());
    const SymmetricTensor<N, T> stress = respond(law, f, history).kirchhoff;
    std::array<T, K> force;
    // GCC 12 takes stress(i, axis) for an index out of bounds where it knows AVX2 alone.
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j)
        if (j == axis) force[i] = stress(i, j);
    for (int r = N; r < K; ++r) force[r] = stress.diagonal[r];
    for (int r = K - 1; r >= N; --r)
      for (int i = 0; i < r; ++i)
        for (int j = 0; j < r; ++j) force[i].slope[j] -= force[i].slope[r] * force[r].slope[j] / force[r].slope[r];
    for (int i = 0; i < N * N; ++i) out[i] = force[i / N].slope[i % N];
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
