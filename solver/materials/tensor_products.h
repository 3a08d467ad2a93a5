#pragma once

#include "solver/materials/tensor.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// r_ij = sum over m of left(i, m) right(m, j) in the N x N block, and left(i, i) right(i, i) for the rest.
template <AnyTensor A, class Left, class Right>
constexpr A contract(Left&& left, Right&& right) {
  constexpr int N = A::size;
  constexpr bool symmetric = A::off_count < N * (N - 1);
  A r{};
  unroll<3>([&](auto i) {
    unroll<3>([&](auto j) {
      if constexpr (i >= N && i == j) r.diagonal[i] = left(i, i) * right(i, i);
      if constexpr (i < N && j < N && !(symmetric && j < i)) {
        auto sum = left(i, 0) * right(0, j);
        unroll<N - 1>([&](auto m) { sum = fused(left(i, m + 1), right(m + 1, j), sum); });
        r(i, j) = sum;
      }
    });
  });
  return r;
}

/// function(i, j) for i < j < N.
template <int N, class Function>
constexpr void for_pairs(Function&& function) {
  unroll<N>([&](auto i) {
    unroll<N>([&](auto j) {
      if constexpr (i < j) function(i, j);
    });
  });
}

template <int N, class T>
constexpr Tensor<N, T> product(const Tensor<N, T>& a, const Tensor<N, T>& b) {
  return contract<Tensor<N, T>>([&](int i, int m) { return a(i, m); }, [&](int m, int j) { return b(m, j); });
}
template <int N, class T>
constexpr Tensor<N, T> product(const SymmetricTensor<N, T>& a, const Tensor<N, T>& b) {
  return contract<Tensor<N, T>>([&](int i, int m) { return a(i, m); }, [&](int m, int j) { return b(m, j); });
}
template <int N, class T>
constexpr Tensor<N, T> product(const Tensor<N, T>& a, const SymmetricTensor<N, T>& b) {
  return contract<Tensor<N, T>>([&](int i, int m) { return a(i, m); }, [&](int m, int j) { return b(m, j); });
}
/// a b^T
template <int N, class T>
constexpr Tensor<N, T> product_transposed(const Tensor<N, T>& a, const Tensor<N, T>& b) {
  return contract<Tensor<N, T>>([&](int i, int m) { return a(i, m); }, [&](int m, int j) { return b(j, m); });
}
/// s s
template <int N, class T>
constexpr SymmetricTensor<N, T> square(const SymmetricTensor<N, T>& s) {
  return contract<SymmetricTensor<N, T>>([&](int i, int m) { return s(i, m); },
                                         [&](int m, int j) { return s(m, j); });
}
/// b = F F^T
template <int N, class T>
constexpr SymmetricTensor<N, T> left_cauchy_green(const Tensor<N, T>& f) {
  return contract<SymmetricTensor<N, T>>([&](int i, int m) { return f(i, m); },
                                         [&](int m, int j) { return f(j, m); });
}
/// C = F^T F
template <int N, class T>
constexpr SymmetricTensor<N, T> right_cauchy_green(const Tensor<N, T>& f) {
  return contract<SymmetricTensor<N, T>>([&](int i, int m) { return f(m, i); },
                                         [&](int m, int j) { return f(m, j); });
}
/// F S F^T
template <int N, class T>
constexpr SymmetricTensor<N, T> push_forward(const Tensor<N, T>& f, const SymmetricTensor<N, T>& s) {
  const Tensor<N, T> fs = product(f, s);
  return contract<SymmetricTensor<N, T>>([&](int i, int m) { return fs(i, m); },
                                         [&](int m, int j) { return f(j, m); });
}

template <int N, class T>
constexpr Tensor<N, T> transpose(const Tensor<N, T>& a) {
  Tensor<N, T> r = a;
  for_pairs<N>([&](auto i, auto j) {
    r(i, j) = a(j, i);
    r(j, i) = a(i, j);
  });
  return r;
}
/// (a + a^T) / 2
template <int N, class T>
constexpr SymmetricTensor<N, T> symmetric_part(const Tensor<N, T>& a) {
  SymmetricTensor<N, T> r{};
  unroll<3>([&](auto i) { r.diagonal[i] = a.diagonal[i]; });
  for_pairs<N>([&](auto i, auto j) { r(i, j) = 0.5 * (a(i, j) + a(j, i)); });
  return r;
}
template <int N, class T>
constexpr Tensor<N, T> full(const SymmetricTensor<N, T>& s) {
  Tensor<N, T> r{};
  unroll<3>([&](auto i) { r.diagonal[i] = s.diagonal[i]; });
  for_pairs<N>([&](auto i, auto j) { r(i, j) = r(j, i) = s(i, j); });
  return r;
}

/// a : b, the sum over all components.
template <AnyTensor A>
constexpr auto double_contraction(const A& a, const A& b) {
  auto diagonal = a.diagonal[0] * b.diagonal[0];
  unroll<2>([&](auto k) { diagonal = fused(a.diagonal[k + 1], b.diagonal[k + 1], diagonal); });
  if constexpr (A::off_count > 0) {
    auto off = a.off[0] * b.off[0];
    unroll<A::off_count - 1>([&](auto k) { off = fused(a.off[k + 1], b.off[k + 1], off); });
    constexpr bool twice = A::off_count < A::size * (A::size - 1);
    diagonal = diagonal + (twice ? 2.0 : 1.0) * off;
  }
  return diagonal;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
