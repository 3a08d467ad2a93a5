#include <gtest/gtest.h>

#include <cmath>

#include "solver/materials/power.h"
#include "tests/epsilon.h"

namespace trajan::test {
namespace {

TEST(Exponential, IsThatOfTheLibraryToTwoUnitsInTheLastPlace) {
  for (double x = -707; x < 708; x += 0.0137) EXPECT_NEAR(exponential(x) / std::exp(x), 1, 2 * epsilon) << x;
  EXPECT_EQ(exponential(0), 1);
  for (double tiny : {1e-18, 1e-200, 1e-308, 1e-320})
    for (double x : {tiny, -tiny}) EXPECT_EQ(exponential(x), 1) << x;
}

TEST(Exponential, StaysPositiveAndFiniteWhereverItIsAskedFor) {
  for (double x : {-1e9, -709.0, 710.0, 1e9}) {
    EXPECT_GT(exponential(x), 0) << x;
    EXPECT_TRUE(std::isnormal(exponential(x))) << x;
  }
}

TEST(Power, IsThatOfTheLibraryToTheRoundingOfItsLogarithm) {
  for (double base : {1e-200, 1e-3, 0.7, 1.0, 3.0, 1e8})
    for (double exponent : {0.31, 1.0, 7.0, -2.5}) {
      const double exact = std::pow(base, exponent);
      if (!std::isnormal(exact)) continue;
      // The logarithm's rounding is magnified by its own size and the exponent.
      const double tolerance = 4 * epsilon * (1 + std::abs(exponent * std::log(base)));
      EXPECT_NEAR(power(base, exponent) / exact, 1, tolerance) << base << ' ' << exponent;
    }
  EXPECT_LT(power(0.0, 0.31), 1e-90);
}

TEST(Power, HasTheDerivativeOfItsDifferences) {
  const Dual<1> x(1.7, 0);
  EXPECT_NEAR(power(x, 2.3).slope[0], 2.3 * std::pow(1.7, 1.3), 1e-14);
}

}  // namespace
}  // namespace trajan::test
