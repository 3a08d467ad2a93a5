#include "solver/accuracy/target.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "solver/accuracy/extrapolation.h"

namespace trajan::accuracy {
namespace {

/// Runs on grids whose answers are 1 + cell_size^order.
std::vector<Rung> rungs(const std::vector<double>& cell_sizes, double order) {
  std::vector<Rung> all;
  for (const double size : cell_sizes) all.push_back({size, 1 + std::pow(size, order), 1 / (size * size * size)});
  return all;
}

TEST(Target, ClaimsNothingOfOneRunAndHalvesItsCells) {
  const Outlook found = outlook(rungs({0.4}, 2), {0.01, 0.4, {}});
  EXPECT_FALSE(found.band);
  EXPECT_DOUBLE_EQ(found.next_cell_size, 0.2);
}

// The exact value is 1. Of two grids the order is not known: a band that holds for the first order is enough.
TEST(Target, HasBandsThatHoldForOrdersFromOneOn) {
  for (const double order : {1.0, 1.5, 2.0, 3.0, 4.0}) {
    const auto all = rungs({0.4, 0.2, 0.1, 0.1 / 1.5}, order);
    for (std::size_t count = 2; count <= all.size(); ++count) {
      const Outlook found = outlook(std::span(all).first(count), {1e-6, 0.4, {}});
      ASSERT_TRUE(found.band);
      EXPECT_GE(*found.band * (1 + 1e-9), all[count - 1].value - 1) << "order " << order << ", runs " << count;
    }
  }
}

TEST(Target, HasABandForValuesThatDoNotConvergeFromThreeRunsOn) {
  const std::vector<Rung> slow = rungs({0.4, 0.2, 0.1}, 0.5);
  EXPECT_GE(*outlook(slow, {1e-6, 0.4, {}}).band, slow.back().value - 1);
  const std::vector<Rung> scattered{{0.4, 1.001, 1}, {0.2, 0.9995, 8}, {0.1, 1.0015, 64}};
  EXPECT_NEAR(*outlook(scattered, {1e-6, 0.4, {}}).band, 3 * 0.002, 1e-9)
      << "three times the spread over four times the cells";
}

TEST(Target, NeverClaimsLessThanATenthOfTheTolerance) {
  const std::vector<Rung> constant{{0.4, 1, 1}, {0.2, 1, 8}, {0.1, 1, 64}};
  EXPECT_FALSE(outlook(std::span(constant).first(2), {0.01, 0.4, {}}).band)
      << "two equal values may be blind to the cells";
  EXPECT_DOUBLE_EQ(*outlook(constant, {0.01, 0.4, {}}).band, 0.001);
}

TEST(Target, TakesASmallStepWhereTheToleranceIsNear) {
  const auto all = rungs({0.4, 0.2}, 2);
  const double band = *outlook(all, {1e-6, 0.4, {}}).band;
  EXPECT_DOUBLE_EQ(outlook(all, {band / 2, 0.4, {}}).next_cell_size, 0.2 / 1.5);
  EXPECT_DOUBLE_EQ(outlook(all, {band / 100, 0.4, {}}).next_cell_size, 0.1);
}

// The finer of two runs answers 1.04.
TEST(Target, CountsHowFarAnotherMethodIsAwayAsLongAsThereAreTwoRuns) {
  const auto all = rungs({0.4, 0.2, 0.1}, 2);
  const auto two = std::span(all).first(2);
  EXPECT_NEAR(*outlook(two, {1e-6, 0.4, 0.97}).band, *outlook(two, {1e-6, 0.4, {}}).band + 0.07, 1e-12);
  EXPECT_EQ(outlook(all, {1e-6, 0.4, 0.97}).band, outlook(all, {1e-6, 0.4, {}}).band);
}

// Values of the second order but for the last, which came too near to the one before.
TEST(Target, DoesNotTrustALastDifferenceThatIsTooSmallToBeTrue) {
  const std::vector<Rung> lucky{{0.4, 1.16, 1}, {0.2, 1.03, 8}, {0.1, 1.018, 64}};
  EXPECT_GE(*outlook(lucky, {1e-6, 0.4, {}}).band, 0.018);
}

TEST(Target, TakesCellsThatAreWholeMultiplesOrPartsOfALength) {
  const auto next = [](double finest, double tolerance) {
    return outlook(rungs({2 * finest, finest}, 2), {tolerance, 1, {}}).next_cell_size;
  };
  constexpr double near = 1e3, far = 1e-6;
  EXPECT_DOUBLE_EQ(next(4, near), 2);
  EXPECT_DOUBLE_EQ(next(2, near), 1);
  EXPECT_DOUBLE_EQ(next(1, near), 1. / 2);
  EXPECT_DOUBLE_EQ(next(1. / 2, near), 1. / 3);
  EXPECT_DOUBLE_EQ(next(1. / 3, near), 1. / 5);
  EXPECT_DOUBLE_EQ(next(1. / 5, near), 1. / 8);
  EXPECT_DOUBLE_EQ(next(1. / 3, far), 1. / 6);
}

TEST(Target, MayCutBodiesInHalvesWhereOneCellIsAsLargeAsTheyAre) {
  const auto next = [](double finest, double unit) {
    return outlook(rungs({2 * finest, finest}, 2), {1e3, unit, {}, true}).next_cell_size;
  };
  EXPECT_DOUBLE_EQ(next(1, 1), 2. / 3);
  EXPECT_DOUBLE_EQ(next(2. / 3, 1), 1. / 2);
  EXPECT_DOUBLE_EQ(next(1. / 2, 1), 1. / 3);
  EXPECT_DOUBLE_EQ(next(0.3, 0), 0.2) << "without a unit";
}

// The error of the finest is 0.1^1.6 = 0.0251, and what is left by the observed order is just that.
TEST(Target, BelievesAnObservedOrderThatIsAboutTheExpectedOne) {
  const auto all = rungs({0.4, 0.2, 0.1}, 1.6);
  EXPECT_NEAR(*outlook(all, {1e-6, 0.4, {}}).band, asymptotic_factor * std::pow(0.1, 1.6), 1e-9);
}

TEST(Target, ForeseesCostsByTheirGrowth) {
  const auto all = rungs({0.4, 0.2}, 2);
  const double band = *outlook(all, {1e-6, 0.4, {}}).band;
  const Outlook found = outlook(all, {band / 100, 0.4, {}});
  EXPECT_NEAR(found.cost_of_next, 8 * all[1].cost, 1e-9 * all[1].cost) << "they grow with the third power";
  EXPECT_NEAR(found.cost_to_reach, 1000 * all[1].cost, 1e-6 * all[1].cost) << "cells of a tenth";
}

}  // namespace
}  // namespace trajan::accuracy
