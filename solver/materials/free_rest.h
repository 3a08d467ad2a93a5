#pragma once

#include "solver/materials/dual.h"
#include "solver/materials/law.h"

/// One step of Newton's method for strains across a plane or bar at which the stress across it vanishes. The
/// derivatives are those of the law itself, by dual numbers.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// A correction below this leaves an error of its square: rounding.
inline constexpr double solved_correction = 1e-8;
/// Newton's method from the last step's answer takes two or three.
inline constexpr int most_corrections = 30;

/// Solves slope * x = -value for the one or two variables of `residual`.
template <int K>
std::array<double, K> newton_correction(const std::array<Dual<K>, K>& residual) {
  if constexpr (K == 1) {
    return {-residual[0].value / residual[0].slope[0]};
  } else {
    const auto &a = residual[0], &b = residual[1];
    const double q = 1 / (a.slope[0] * b.slope[1] - a.slope[1] * b.slope[0]);
    return {q * (a.slope[1] * b.value - b.slope[1] * a.value), q * (b.slope[0] * a.value - a.slope[0] * b.value)};
  }
}

template <int K>
bool is_solved(const std::array<double, K>& correction) {
  bool solved = true;
  unroll<K>([&](auto k) {
    solved = solved & (correction[k] < solved_correction) & (correction[k] > -solved_correction);
  });
  return solved;
}

/// Corrects the stretches across of `f` once, by factors near 1. `before` is the history at the beginning of
/// the step.
template <int N, class Law>
bool correct_rest(const Law& law, const HistoryOf<Law>& before, double dt, Tensor<N>& f) {
  constexpr int K = 3 - N;
  using T = Dual<K>;
  Tensor<N, T> stretched = cast<T>(f);
  unroll<K>([&](auto k) { stretched.diagonal[N + k] = T(f.diagonal[N + k], k); });
  HistoryOf<Law, T> history;
  unroll<history_count<Law>()>([&](auto h) { history[h] = before[h]; });
  if constexpr (history_count<Law>() > 0) law.evolve(stretched, dt, history);
  const SymmetricTensor<N, T> stress = respond(law, stretched, history).kirchhoff;
  std::array<T, K> residual;
  unroll<K>([&](auto k) {
    residual[k] = stress.diagonal[N + k];
    // Derivatives by logarithms of the stretches.
    unroll<K>([&](auto j) { residual[k].slope[j] *= f.diagonal[N + j]; });
  });
  const std::array<double, K> correction = newton_correction<K>(residual);
  // The exponential function to second order, which is positive wherever a wild guess leads.
  unroll<K>([&](auto k) { f.diagonal[N + k] *= 1 + correction[k] * (1 + 0.5 * correction[k]); });
  return is_solved<K>(correction);
}

/// A step of a rate law but for its damage: volume first, so that the law knows the end of the step.
template <class Law, int N, class T, int H>
void advance_undamaged(const Law& law, const Tensor<N, T>& g, double dt, RateState<N, T, H>& state) {
  state.volume_ratio = state.volume_ratio * determinant(plus_diagonal(g, 1.0));
  law.advance(g, dt, state);
}

/// A step of a rate law.
template <class Law, int N, class T, int H>
void advance_state(const Law& law, const Tensor<N, T>& g, double dt, RateState<N, T, H>& state) {
  advance_undamaged(law, g, dt, state);
  if constexpr (is_damaged<Law>()) {
    const auto drive = law.drive(state);
    law.grow(law.damage().damage(drive.ratio), drive, state);
  }
}

/// Corrects the strains across of the step's displacement gradient `g` once, by at most 1 / 4.
template <int N, class Law, int H>
bool correct_rest(const Law& law, const RateState<N, double, H>& before, double dt, Tensor<N>& g) {
  constexpr int K = 3 - N;
  using T = Dual<K>;
  Tensor<N, T> strained = cast<T>(g);
  unroll<K>([&](auto k) { strained.diagonal[N + k] = T(g.diagonal[N + k], k); });
  RateState<N, T, H> state{cast<T>(before.stress), T(before.volume_ratio), {}};
  unroll<H>([&](auto h) { state.history[h] = before.history[h]; });
  advance_state(law, strained, dt, state);
  const SymmetricTensor<N, T> stress = cauchy_stress(law, state);
  std::array<T, K> residual;
  unroll<K>([&](auto k) { residual[k] = stress.diagonal[N + k]; });
  std::array<double, K> correction = newton_correction<K>(residual);
  unroll<K>([&](auto k) {
    correction[k] = correction[k] > 0.25 ? 0.25 : correction[k] < -0.25 ? -0.25 : correction[k];
    g.diagonal[N + k] += correction[k];
  });
  return is_solved<K>(correction);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
