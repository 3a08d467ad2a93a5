#pragma once

#include "solver/materials/tensor.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// r_ij = sum over m of term(i, j, m) in the N x N block, and term(i, i, i) for the rest.
template <AnyTensor A, class Term>
constexpr A contract(Term&& term) {
  constexpr int N = A::size;
  A r{};
  for (int i = 0; i < 3; ++i) {
    const bool rest = i >= N;
    r.diagonal[i] = term(i, i, rest ? i : 0);
    for (int m = 1; m < (rest ? 1 : N); ++m) r.diagonal[i] = r.diagonal[i] + term(i, i, m);
  }
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      if (i == j || (A::off_count < N * (N - 1) && j < i)) continue;
      auto& sum = r(i, j);
      sum = term(i, j, 0);
      for (int m = 1; m < N; ++m) sum = sum + term(i, j, m);
    }
  return r;
}

template <int N, class T>
constexpr Tensor<N, T> product(const Tensor<N, T>& a, const Tensor<N, T>& b) {
  return contract<Tensor<N, T>>([&](int i, int j, int m) { return a(i, m) * b(m, j); });
}
template <int N, class T>
constexpr Tensor<N, T> product(const SymmetricTensor<N, T>& a, const Tensor<N, T>& b) {
  return contract<Tensor<N, T>>([&](int i, int j, int m) { return a(i, m) * b(m, j); });
}
template <int N, class T>
constexpr Tensor<N, T> product(const Tensor<N, T>& a, const SymmetricTensor<N, T>& b) {
  return contract<Tensor<N, T>>([&](int i, int j, int m) { return a(i, m) * b(m, j); });
}
/// a b^T
template <int N, class T>
constexpr Tensor<N, T> product_transposed(const Tensor<N, T>& a, const Tensor<N, T>& b) {
  return contract<Tensor<N, T>>([&](int i, int j, int m) { return a(i, m) * b(j, m); });
}
/// s s
template <int N, class T>
constexpr SymmetricTensor<N, T> square(const SymmetricTensor<N, T>& s) {
  return contract<SymmetricTensor<N, T>>([&](int i, int j, int m) { return s(i, m) * s(m, j); });
}
/// b = F F^T
template <int N, class T>
constexpr SymmetricTensor<N, T> left_cauchy_green(const Tensor<N, T>& f) {
  return contract<SymmetricTensor<N, T>>([&](int i, int j, int m) { return f(i, m) * f(j, m); });
}
/// C = F^T F
template <int N, class T>
constexpr SymmetricTensor<N, T> right_cauchy_green(const Tensor<N, T>& f) {
  return contract<SymmetricTensor<N, T>>([&](int i, int j, int m) { return f(m, i) * f(m, j); });
}
/// F S F^T
template <int N, class T>
constexpr SymmetricTensor<N, T> push_forward(const Tensor<N, T>& f, const SymmetricTensor<N, T>& s) {
  const Tensor<N, T> fs = product(f, s);
  return contract<SymmetricTensor<N, T>>([&](int i, int j, int m) { return fs(i, m) * f(j, m); });
}

template <int N, class T>
constexpr Tensor<N, T> transpose(const Tensor<N, T>& a) {
  Tensor<N, T> r = a;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) r(i, j) = a(j, i);
  return r;
}
/// (a + a^T) / 2
template <int N, class T>
constexpr SymmetricTensor<N, T> symmetric_part(const Tensor<N, T>& a) {
  SymmetricTensor<N, T> r{};
  for (int i = 0; i < 3; ++i) r.diagonal[i] = a.diagonal[i];
  for (int i = 0; i < N; ++i)
    for (int j = i + 1; j < N; ++j) r(i, j) = 0.5 * (a(i, j) + a(j, i));
  return r;
}
template <int N, class T>
constexpr Tensor<N, T> full(const SymmetricTensor<N, T>& s) {
  Tensor<N, T> r{};
  for (int i = 0; i < 3; ++i) r.diagonal[i] = s.diagonal[i];
  for (int i = 0; i < N; ++i)
    for (int j = i + 1; j < N; ++j) r(i, j) = r(j, i) = s(i, j);
  return r;
}

/// a : b, the sum over all components.
template <AnyTensor A>
constexpr auto double_contraction(const A& a, const A& b) {
  auto diagonal = a.diagonal[0] * b.diagonal[0] + a.diagonal[1] * b.diagonal[1] + a.diagonal[2] * b.diagonal[2];
  if constexpr (A::off_count > 0) {
    auto off = a.off[0] * b.off[0];
    for (int k = 1; k < A::off_count; ++k) off = off + a.off[k] * b.off[k];
    constexpr bool twice = A::off_count < A::size * (A::size - 1);
    diagonal = diagonal + (twice ? 2.0 : 1.0) * off;
  }
  return diagonal;
}

template <AnyTensor A>
constexpr typename A::Scalar determinant(const A& a) {
  const auto& d = a.diagonal;
  if constexpr (A::size == 1) return d[0] * d[1] * d[2];
  if constexpr (A::size == 2) return (d[0] * d[1] - a(0, 1) * a(1, 0)) * d[2];
  if constexpr (A::size == 3)
    return d[0] * (d[1] * d[2] - a(1, 2) * a(2, 1)) - a(0, 1) * (a(1, 0) * d[2] - a(1, 2) * a(2, 0)) +
           a(0, 2) * (a(1, 0) * a(2, 1) - d[1] * a(2, 0));
}

template <AnyTensor A>
constexpr A inverse(const A& a) {
  using T = typename A::Scalar;
  const auto& d = a.diagonal;
  A r{};
  if constexpr (A::size == 3) {
    const T q = 1.0 / determinant(a);
    // Cofactors by cyclic indices, transposed.
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int k = (i + 1) % 3, l = (i + 2) % 3, m = (j + 1) % 3, n = (j + 2) % 3;
        r(j, i) = q * (a(k, m) * a(l, n) - a(k, n) * a(l, m));
      }
  } else {
    for (int k = A::size; k < 3; ++k) r.diagonal[k] = 1.0 / d[k];
    if constexpr (A::size == 1) r.diagonal[0] = 1.0 / d[0];
    if constexpr (A::size == 2) {
      const T q = 1.0 / (d[0] * d[1] - a(0, 1) * a(1, 0));
      r.diagonal[0] = q * d[1];
      r.diagonal[1] = q * d[0];
      for (int k = 0; k < A::off_count; ++k) r.off[k] = -(q * a.off[k]);
    }
  }
  return r;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
