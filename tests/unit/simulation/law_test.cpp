#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/materials/eigenvalues.h"
#include "solver/materials/logarithm.h"
#include "solver/materials/tensor_inverse.h"
#include "solver/materials/tensor_products.h"
#include "tests/epsilon.h"

namespace trajan {
namespace {

using test::epsilon;

TEST(Logarithm, IsThatOfTheLibraryToAFewUnitsInTheLastPlace) {
  for (double x = 0x1p-40; x < 0x1p40; x *= 1.0173) {
    // Near 1 the logarithm is small and its error that of x's own rounding.
    const double tolerance = 3 * epsilon * std::max(std::abs(std::log(x)), 0x1p-30);
    EXPECT_NEAR(natural_logarithm(x), std::log(x), tolerance) << x;
  }
  EXPECT_EQ(natural_logarithm(1), 0);
}

template <int N>
Tensor<N> some_tensor() {
  Tensor<N> a{};
  for (int k = 0; k < 3; ++k) a.diagonal[k] = 1.5 - 0.3 * k;
  for (int k = 0; k < Tensor<N>::off_count; ++k) a.off[k] = 0.2 - 0.1 * k;
  return a;
}

template <int N>
void expect_inverse() {
  const Tensor<N> a = some_tensor<N>();
  const Tensor<N> difference = product(a, inverse(a)) - identity<N>();
  // A few roundings of numbers of order 1.
  EXPECT_NEAR(double_contraction(difference, difference), 0, 64 * epsilon * epsilon);
  EXPECT_NEAR(determinant(a) * determinant(inverse(a)), 1, 16 * epsilon);
  const SymmetricTensor<N> b = left_cauchy_green(a);
  EXPECT_NEAR(determinant(b), determinant(a) * determinant(a), 64 * epsilon);
}

TEST(Tensor, TimesItsInverseIsTheIdentityInAllDimensions) {
  expect_inverse<1>();
  expect_inverse<2>();
  expect_inverse<3>();
}

TEST(Tensor, HasEigenvaluesOfTheRightSumsOfPowers) {
  for (const SymmetricTensor<3>& a :
       {left_cauchy_green(some_tensor<3>()), SymmetricTensor<3>{{1, 1, 1}, {0, 0, 0}},
        SymmetricTensor<3>{{2, -1, 3}, {1e-9, 4, -2}}, SymmetricTensor<3>{{0, 0, 0}, {1, 1, 1}}}) {
    const std::array<double, 3> e = eigenvalues(a);
    const double size = std::sqrt(double_contraction(a, a)), rounding = 32 * epsilon;
    EXPECT_NEAR(e[0] + e[1] + e[2], trace(a), rounding * size);
    EXPECT_NEAR(e[0] * e[0] + e[1] * e[1] + e[2] * e[2], size * size, rounding * size * size);
    EXPECT_NEAR(e[0] * e[1] * e[2], determinant(a), rounding * size * size * size);
  }
}

}  // namespace
}  // namespace trajan
