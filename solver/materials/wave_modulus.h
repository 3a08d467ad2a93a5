#pragma once

#include <algorithm>

#include "solver/materials/dimension.h"
#include "solver/materials/eigenvalues.h"
#include "solver/materials/free_rest.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Squares of the principal stretches of F, those of the grid's axes first.
template <int N>
std::array<double, 3> squared_stretches(const Tensor<N>& f) {
  return eigenvalues(left_cauchy_green(f));
}

template <int N>
double smallest_squared_stretch(const Tensor<N>& f) {
  const std::array<double, 3> b = squared_stretches(f);
  return *std::min_element(b.begin(), b.begin() + N);
}

/// Slopes of the principal Kirchhoff stresses by logarithms of the stretches, without those that are free.
using PrincipalSlopes = std::array<Dual<3>, 3>;
inline void release_rest(PrincipalSlopes& tau, int axes) {
  for (int r = 2; r >= axes; --r) {
    const double q = 1 / tau[r].slope[r];
    for (int i = 0; i < r; ++i)
      for (int j = 0; j < r; ++j) tau[i].slope[j] -= tau[i].slope[r] * q * tau[r].slope[j];
  }
}

/// The largest modulus rho c^2 of plane waves along principal directions in an isotropic material, per
/// reference volume, with unit normals of the current configuration or, total Lagrangian, of the reference one.
/// With b_i the squared stretches, tau_i the principal Kirchhoff stresses (Ogden 1997, section 6.3.2):
/// longitudinal d tau_i / d ln lambda_i - tau_i; transverse, along j and moving along i,
/// b_j (tau_i - tau_j) / (b_i - b_j), whose limit is half of d (tau_i - tau_j) / d ln lambda_i.
template <Dimension D, class Law, int N>
double isotropic_wave_modulus(const Law& law, const Tensor<N>& f, const HistoryOf<Law>& history,
                              bool total_lagrangian) {
  const std::array<double, 3> b = squared_stretches(f);
  Tensor<1, Dual<3>> principal{};
  for (int i = 0; i < 3; ++i) {
    const double stretch = square_root(b[i]);
    principal.diagonal[i] = Dual<3>(stretch);
    principal.diagonal[i].slope[i] = stretch;
  }
  HistoryOf<Law, Dual<3>> constant;
  for (std::size_t h = 0; h < history.size(); ++h) constant[h] = history[h];
  const SymmetricTensor<1, Dual<3>> stress = respond(law, principal, constant).kirchhoff;
  PrincipalSlopes tau{stress.diagonal[0], stress.diagonal[1], stress.diagonal[2]};
  if constexpr (rest_is_free(D)) release_rest(tau, N);
  double largest = 0;
  for (int j = 0; j < N; ++j)
    for (int i = 0; i < N; ++i) {
      double modulus = tau[i].slope[i] - tau[i].value;
      if (i != j) {
        const double apart = b[i] - b[j];
        modulus = std::abs(apart) > 1e-4 * b[i] ? b[j] * (tau[i].value - tau[j].value) / apart
                                                : 0.5 * (tau[i].slope[i] - tau[j].slope[i]);
      }
      largest = std::max(largest, total_lagrangian ? modulus / b[j] : modulus);
    }
  return largest;
}

/// The largest modulus rho c^2 of plane waves in a deformed finite law.
template <Dimension D, class Law, int N>
double wave_modulus(const Law& law, const Tensor<N>& f, const HistoryOf<Law>& history, bool total_lagrangian) {
  if constexpr (requires { law.template wave_modulus<D>(f, total_lagrangian); })
    return law.template wave_modulus<D>(f, total_lagrangian);
  else
    return isotropic_wave_modulus<D>(law, f, history, total_lagrangian);
}

/// History at the beginning.
template <class Law>
HistoryOf<Law> initial_history(const Law& law, std::uint64_t particle) {
  HistoryOf<Law> history{};
  if constexpr (history_count<Law>() > 0) {
    for (std::size_t h = 0; h < history.size(); ++h) history[h] = Law::history[h].initial;
    if constexpr (requires { law.begin(particle, history.data()); }) law.begin(particle, history.data());
  }
  return history;
}

/// The modulus of the fastest wave at rest.
template <Dimension D, class Law>
double wave_modulus_at_rest(const Law& law) {
  constexpr int N = grid_axes(D);
  const HistoryOf<Law> history = initial_history(law, 0);
  if constexpr (Law::rate_form)
    return law.moduli(RateState<N, double, history_count<Law>()>{{}, 1, history}).wave_modulus(D);
  else
    return wave_modulus<D>(law, identity<N>(), history, false);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
