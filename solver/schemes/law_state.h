#pragma once

#include <array>
#include <cstdint>

#include "solver/executors/block.h"
#include "solver/materials/dimension.h"
#include "solver/materials/law.h"
#include "solver/materials/unroll.h"

/// Where the tensors of a block's particles lie, and access to them by particle.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

constexpr Attribute after(Attribute first, int steps) {
  return static_cast<Attribute>(static_cast<int>(first) + steps);
}
constexpr Attribute deformation_attribute(int i, int j) { return after(Attribute::deformation_xx, 3 * i + j); }

/// The time that a deformation takes.
inline double deformation_time(const Block& b) { return b.scratch->deform_share * b.sweep->drift; }

/// Components of a tensor's diagonal that are stored: all, or those of the grid's axes.
constexpr int stored_diagonal(int grid_axes, bool rest_is_stored) { return rest_is_stored ? 3 : grid_axes; }

/// Deformation gradient. The rest is 1 unless it is stored.
template <int N, bool RestIsStored>
struct DeformationArrays {
  static constexpr int diagonal_count = stored_diagonal(N, RestIsStored);
  double* diagonal[3];
  double* off[Tensor<N>::off_count + 1];

  explicit DeformationArrays(const Block& b) {
    unroll<diagonal_count>([&](auto k) { diagonal[k] = b[deformation_attribute(k, k)]; });
    unroll<N>([&](auto i) {
      unroll<N>([&](auto j) {
        if constexpr (i != j) off[Tensor<N>::place(i, j)] = b[deformation_attribute(i, j)];
      });
    });
  }
  Tensor<N> at(int i) const {
    Tensor<N> f = identity<N>();
    unroll<diagonal_count>([&](auto k) { f.diagonal[k] = diagonal[k][i]; });
    unroll<Tensor<N>::off_count>([&](auto k) { f.off[k] = off[k][i]; });
    return f;
  }
  void set(int i, const Tensor<N>& f) const {
    unroll<diagonal_count>([&](auto k) { diagonal[k][i] = f.diagonal[k]; });
    unroll<Tensor<N>::off_count>([&](auto k) { off[k][i] = f.off[k]; });
  }
};

/// Cauchy stress. The rest is 0 unless it is stored.
template <int N, bool RestIsStored>
struct StressArrays {
  static constexpr int diagonal_count = stored_diagonal(N, RestIsStored);
  double* diagonal[3];
  double* off[SymmetricTensor<N>::off_count + 1];

  explicit StressArrays(const Block& b) {
    unroll<diagonal_count>([&](auto k) { diagonal[k] = b[after(Attribute::stress_xx, k)]; });
    unroll<SymmetricTensor<N>::off_count>([&](auto k) { off[k] = b[after(Attribute::stress_xy, k)]; });
  }
  SymmetricTensor<N> at(int i) const {
    SymmetricTensor<N> s{};
    unroll<diagonal_count>([&](auto k) { s.diagonal[k] = diagonal[k][i]; });
    unroll<SymmetricTensor<N>::off_count>([&](auto k) { s.off[k] = off[k][i]; });
    return s;
  }
  void set(int i, const SymmetricTensor<N>& s) const {
    unroll<diagonal_count>([&](auto k) { diagonal[k][i] = s.diagonal[k]; });
    unroll<SymmetricTensor<N>::off_count>([&](auto k) { off[k][i] = s.off[k]; });
  }
};

template <int Count>
struct HistoryArrays {
  double* variable[Count + 1];

  explicit HistoryArrays(const Block& b) {
    unroll<Count>([&](auto h) { variable[h] = b[after(Attribute::history_0, h)]; });
  }
  std::array<double, static_cast<std::size_t>(Count)> at(int i) const {
    std::array<double, static_cast<std::size_t>(Count)> values{};
    unroll<Count>([&](auto h) { values[static_cast<std::size_t>(h)] = variable[h][i]; });
    return values;
  }
  void set(int i, const std::array<double, static_cast<std::size_t>(Count)>& values) const {
    unroll<Count>([&](auto h) { variable[h][i] = values[static_cast<std::size_t>(h)]; });
  }
};

/// Velocity gradient in a thread's working memory.
template <Dimension D>
struct GradientArrays {
  static constexpr int N = grid_axes(D);
  Scratch& scratch;

  Tensor<N> at(int i) const {
    Tensor<N> g{};
    unroll<N * N>([&](auto k) { g(k / N, k % N) = scratch.gradient[k][i]; });
    if constexpr (D == Dimension::axisymmetric) g.diagonal[2] = scratch.gradient_rest[i];
    return g;
  }
  void set(int i, const Tensor<N>& g) const {
    unroll<N * N>([&](auto k) { scratch.gradient[k][i] = g(k / N, k % N); });
    if constexpr (D == Dimension::axisymmetric) scratch.gradient_rest[i] = g.diagonal[2];
  }
};

/// Whether bodies of finite laws, or total Lagrangian ones of rate laws, store stretches of the rest.
constexpr bool stores_rest_stretch(Dimension d, bool rate_form) {
  return d == Dimension::axisymmetric || (!rate_form && rest_is_free(d));
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
