#include "solver/materials/single.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/materials/linear_elastic.h"
#include "solver/materials/neo_hookean.h"
#include "tests/epsilon.h"

namespace trajan::test {
namespace {

constexpr double single_epsilon = std::numeric_limits<float>::epsilon();

/// No two components alike, and a spin.
template <int N>
Tensor<N> step_of(double size) {
  Tensor<N> g{};
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) g(i, j) = size * (0.3 + 0.41 * i - 0.73 * j + 0.17 * i * j);
  if constexpr (N < 3) g.diagonal[2] = 0.2 * size;
  return g;
}
template <class To, class From, class Number = typename To::Scalar>
To converted(const From& from) {
  To to{};
  for (int k = 0; k < 3; ++k) to.diagonal[k] = Number(from.diagonal[k]);
  for (int k = 0; k < From::off_count; ++k) to.off[k] = Number(from.off[k]);
  return to;
}
/// Largest difference of two tensors' components.
template <class A>
double difference(const A& a, const A& b) {
  double worst = 0;
  for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(a.diagonal[k] - b.diagonal[k]));
  for (int k = 0; k < A::off_count; ++k) worst = std::max(worst, std::abs(a.off[k] - b.off[k]));
  return worst;
}
template <int N>
SymmetricTensor<N> widened(const SymmetricTensor<N, Single>& a) {
  SymmetricTensor<N> r{};
  for (int k = 0; k < 3; ++k) r.diagonal[k] = a.diagonal[k].value;
  for (int k = 0; k < SymmetricTensor<N>::off_count; ++k) r.off[k] = a.off[k].value;
  return r;
}

/// The same in space.
template <class InSpace, AnyTensor A>
InSpace in_space(const A& a) {
  InSpace whole{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i == j || (i < A::size && j < A::size)) whole(i, j) = a(i, j);
  return whole;
}

constexpr double modulus = 1000, poissons_ratio = 0.3;

/// As Hughes and Winget (1980) have it: the increments of the configuration at mid-step, and a rotation by which
/// what was there turns with half of what the strain adds.
SymmetricTensor<3> stepped(const Tensor<3>& g, const SymmetricTensor<3>& stress) {
  const Tensor<3> mid = product(g, inverse(plus_diagonal(0.5 * g, 1.0)));
  const Tensor<3> half_spin = 0.25 * (mid - transpose(mid));
  const Tensor<3> rotation = product(inverse(plus_diagonal(-1.0 * half_spin, 1.0)), plus_diagonal(half_spin, 1.0));
  const double shear = modulus / (2 + 2 * poissons_ratio),
               lame = 2 * shear * poissons_ratio / (1 - 2 * poissons_ratio);
  const SymmetricTensor<3> half = plus_diagonal(shear * symmetric_part(mid), lame / 2 * trace(mid));
  return push_forward(rotation, stress + half) + half;
}

template <int N>
void expect_changes(double size) {
  const double parameters[] = {modulus, poissons_ratio};
  const LinearElastic law(parameters, 1);
  const Tensor<N> g = step_of<N>(size);
  RateState<N> state{symmetric_part(step_of<N>(7.0)), 1, {}};
  const SymmetricTensor<N> before = state.stress, change = law.stress_change(g, before);
  const SymmetricTensor<3> exact = stepped(in_space<Tensor<3>>(g), in_space<SymmetricTensor<3>>(before));
  // Some thirty operations round.
  const double rounding = 30 * epsilon * (10 + modulus * size);
  EXPECT_LT(difference(in_space<SymmetricTensor<3>>(before + change), exact), rounding) << N << ' ' << size;
  law.advance(g, 0.1, state);
  EXPECT_LT(difference(in_space<SymmetricTensor<3>>(state.stress), exact), rounding) << N << ' ' << size;
  // To all digits of the change itself, of which stresses of 10 have none left where it is small.
  const auto in_floats =
      law.stress_change(converted<Tensor<N, Single>>(g), converted<SymmetricTensor<N, Single>>(before));
  EXPECT_LT(difference(widened(in_floats), change), 20 * single_epsilon * modulus * size) << N << ' ' << size;
}

TEST(StressChange, IsWhatAStepAddsAndToAllDigitsInFloats) {
  for (double size : {1.0, 0.2, 1e-3, 1e-6, 1e-10}) {
    expect_changes<1>(size);
    expect_changes<2>(size);
    expect_changes<3>(size);
  }
}

template <int N>
void expect_dilation(double size) {
  const Tensor<N> g = step_of<N>(size);
  EXPECT_NEAR(dilation(g), determinant(plus_diagonal(g, 1.0)) - 1, 4 * epsilon) << N << ' ' << size;
  const double in_floats = dilation(converted<Tensor<N, Single>>(g)).value;
  EXPECT_NEAR(in_floats, dilation(g), 10 * single_epsilon * size) << N << ' ' << size;
}

TEST(Dilation, IsTheDeterminantLessOneToAllDigitsInFloats) {
  for (double size : {0.2, 1e-3, 1e-6, 1e-10}) {
    expect_dilation<1>(size);
    expect_dilation<2>(size);
    expect_dilation<3>(size);
  }
}

TEST(LogarithmOfOneMore, IsThatOfTheLibraryToThreeUnitsInTheLastPlace) {
  for (double x : {-0.99, -0.5, -0.3, -1e-3, -1e-9, -1e-20, 1e-20, 1e-9, 1e-3, 0.3, 0.42, 0.9, 1.7, 1e5}) {
    const Single rounded = x;
    const double exact = std::log1p(static_cast<double>(rounded.value));
    EXPECT_NEAR(logarithm_of_one_more(rounded).value / exact, 1, 3 * single_epsilon) << x;
  }
  EXPECT_EQ(logarithm_of_one_more(Single()).value, 0);
}

template <int N>
void expect_kirchhoff(double size) {
  const double parameters[] = {modulus, poissons_ratio};
  const NeoHookean law(parameters, 1);
  const Tensor<N> h = step_of<N>(size);
  const SymmetricTensor<N> exact = law.response(plus_diagonal(h, 1.0)).kirchhoff;
  const auto in_floats = law.kirchhoff_of_change(converted<Tensor<N, Single>>(h));
  EXPECT_LT(difference(widened(in_floats), exact), 20 * single_epsilon * modulus * size) << N << ' ' << size;
}

TEST(KirchhoffOfChange, IsTheResponseToAllDigitsInFloats) {
  // Doubles lose the more digits the less F differs from 1.
  for (double size : {0.2, 1e-3, 1e-6, 1e-8}) {
    expect_kirchhoff<1>(size);
    expect_kirchhoff<2>(size);
    expect_kirchhoff<3>(size);
  }
}

}  // namespace
}  // namespace trajan::test
