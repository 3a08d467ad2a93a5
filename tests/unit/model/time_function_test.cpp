#include "solver/model/time_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace trajan {
namespace {

// One rounding of cos or sin near 1.
constexpr double rounding = 1e-15;

TEST(TimeFunction, IsOneUnlessGiven) { EXPECT_EQ(TimeFunction()(3), 1); }

TEST(TimeFunction, ConstantHoldsAtAllTimes) {
  const TimeFunction function(-2.5);
  EXPECT_EQ(function(-1), -2.5);
  EXPECT_EQ(function(1e9), -2.5);
}

TEST(TimeFunction, RampRisesOnceFromZeroToOne) {
  const TimeFunction ramp(Ramp{1, 4, false});
  EXPECT_EQ(ramp(0.5), 0);
  EXPECT_EQ(ramp(1), 0);
  EXPECT_EQ(ramp(2), 0.25);
  EXPECT_EQ(ramp(5), 1);
  EXPECT_EQ(ramp(100), 1);
}

TEST(TimeFunction, SmoothRampStartsAndEndsWithoutSlope) {
  const TimeFunction ramp(Ramp{1, 4, true});
  EXPECT_NEAR(ramp(3), 0.5, rounding);
  EXPECT_EQ(ramp(5), 1);
  // (1 - cos(pi s)) / 2 = (pi s / 2)^2 to leading order.
  const double s = 1e-4, quadratic = std::pow(std::numbers::pi * s / 2, 2);
  EXPECT_NEAR(ramp(1 + 4 * s) / quadratic, 1, 1e-6);
  EXPECT_NEAR((1 - ramp(5 - 4 * s)) / quadratic, 1, 1e-6);
}

TEST(TimeFunction, SineHasItsFrequencyInCyclesPerTime) {
  const TimeFunction sine(Sine{0.25, std::numbers::pi / 2});
  EXPECT_NEAR(sine(0), 1, rounding);
  EXPECT_NEAR(sine(1), 0, rounding);
  EXPECT_NEAR(sine(2), -1, rounding);
}

TEST(TimeFunction, TableIsLinearBetweenItsPointsAndConstantOutside) {
  const TimeFunction table(Table{{1, 2, 4}, {10, 20, 0}});
  EXPECT_EQ(table(0), 10);
  EXPECT_EQ(table(1), 10);
  EXPECT_EQ(table(1.5), 15);
  EXPECT_EQ(table(2), 20);
  EXPECT_EQ(table(3), 10);
  EXPECT_EQ(table(4), 0);
  EXPECT_EQ(table(5), 0);
  EXPECT_EQ(TimeFunction(Table{{1}, {7}})(-3), 7);
}

TEST(TimeFunction, ExpressionIsOfTime) {
  EXPECT_EQ(TimeFunction(Formula(Expression("t^2", "t", {}), "time", true))(3), 9);
}

}  // namespace
}  // namespace trajan
