#pragma once

#include <type_traits>

#include "solver/materials/fused.h"
#include "solver/materials/unroll.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// A tensor of three-dimensional space of which only the first N axes are axes of the grid. No shear joins
/// the other axes, the "rest": of them only the diagonal components exist. For N = 2 these are xx, yy, zz
/// and xy, yx; in axisymmetric scenes zz is the hoop direction.
template <int N, class T = double>
struct Tensor {
  static constexpr int size = N;
  static constexpr int off_count = N * (N - 1);
  using Scalar = T;

  T diagonal[3];                         ///< xx, yy, zz
  T off[off_count > 0 ? off_count : 1];  ///< the others of the N x N block, row by row

  /// i = j, or both below N.
  constexpr T& operator()(int i, int j) { return i == j ? diagonal[i] : off[place(i, j)]; }
  constexpr const T& operator()(int i, int j) const { return i == j ? diagonal[i] : off[place(i, j)]; }
  static constexpr int place(int i, int j) { return i * (N - 1) + (j > i ? j - 1 : j); }
};

/// The same for symmetric tensors.
template <int N, class T = double>
struct SymmetricTensor {
  static constexpr int size = N;
  static constexpr int off_count = N * (N - 1) / 2;
  using Scalar = T;

  T diagonal[3];                         ///< xx, yy, zz
  T off[off_count > 0 ? off_count : 1];  ///< xy; in three dimensions xy, yz, xz

  /// i = j, or both below N.
  constexpr T& operator()(int i, int j) { return i == j ? diagonal[i] : off[place(i, j)]; }
  constexpr const T& operator()(int i, int j) const { return i == j ? diagonal[i] : off[place(i, j)]; }
  static constexpr int place(int i, int j) { return i + j == 1 ? 0 : i + j == 3 ? 1 : 2; }
};

template <class A>
concept AnyTensor = std::is_same_v<A, Tensor<A::size, typename A::Scalar>> ||
    std::is_same_v<A, SymmetricTensor<A::size, typename A::Scalar>>;

/// What `function` makes of every component, or of every two of the same place.
template <AnyTensor A, class Function>
constexpr A for_components(const A& a, Function&& function) {
  A r{};
  unroll<3>([&](auto k) { r.diagonal[k] = function(a.diagonal[k]); });
  unroll<A::off_count>([&](auto k) { r.off[k] = function(a.off[k]); });
  return r;
}
template <AnyTensor A, class Function>
constexpr A for_components(const A& a, const A& b, Function&& function) {
  A r{};
  unroll<3>([&](auto k) { r.diagonal[k] = function(a.diagonal[k], b.diagonal[k]); });
  unroll<A::off_count>([&](auto k) { r.off[k] = function(a.off[k], b.off[k]); });
  return r;
}

template <AnyTensor A>
constexpr A operator+(const A& a, const A& b) {
  return for_components(a, b, [](const auto& x, const auto& y) { return x + y; });
}
template <AnyTensor A>
constexpr A operator-(const A& a, const A& b) {
  return for_components(a, b, [](const auto& x, const auto& y) { return x - y; });
}
/// `s` is a double or of the tensor's own number type.
template <AnyTensor A, class S>
constexpr A operator*(const S& s, const A& a) {
  return for_components(a, [&](const auto& x) { return s * x; });
}
/// s a + b
template <AnyTensor A, class S>
constexpr A fused(const S& s, const A& a, const A& b) {
  return for_components(a, b, [&](const auto& x, const auto& y) { return fused(s, x, y); });
}
/// a + s 1
template <AnyTensor A, class S>
constexpr A plus_diagonal(A a, const S& s) {
  unroll<3>([&](auto k) { a.diagonal[k] = a.diagonal[k] + s; });
  return a;
}

template <AnyTensor A>
constexpr A identity() {
  return plus_diagonal(A{}, typename A::Scalar(1));
}
template <int N, class T = double>
constexpr Tensor<N, T> identity() {
  return identity<Tensor<N, T>>();
}

/// The same components as another number type.
template <class U, int N, class T>
constexpr Tensor<N, U> cast(const Tensor<N, T>& a) {
  Tensor<N, U> r{};
  unroll<3>([&](auto k) { r.diagonal[k] = U(a.diagonal[k]); });
  unroll<Tensor<N, T>::off_count>([&](auto k) { r.off[k] = U(a.off[k]); });
  return r;
}
template <class U, int N, class T>
constexpr SymmetricTensor<N, U> cast(const SymmetricTensor<N, T>& a) {
  SymmetricTensor<N, U> r{};
  unroll<3>([&](auto k) { r.diagonal[k] = U(a.diagonal[k]); });
  unroll<SymmetricTensor<N, T>::off_count>([&](auto k) { r.off[k] = U(a.off[k]); });
  return r;
}

template <AnyTensor A>
constexpr auto trace(const A& a) {
  return a.diagonal[0] + a.diagonal[1] + a.diagonal[2];
}
/// a - tr(a) / 3 1
template <AnyTensor A>
constexpr A deviator(const A& a) {
  return plus_diagonal(a, trace(a) * (-1.0 / 3));
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
