#include "solver/accuracy/trade.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trajan::accuracy {
namespace {

TEST(Trade, MarksWhatNoOtherRunBeatsInBothErrorAndCost) {
  const std::vector<Point> points{
      {1, 0.1, 0, 1}, {2, 0.05, 0, 0.5}, {3, 0.06, 1, 1}, {4, 0.01, 1, 0.5}, {4, 0.02, 2, 1}};
  EXPECT_THAT(pareto_set(points), testing::ElementsAre(true, true, false, true, false));
}

TEST(Trade, KeepsEqualRunsBoth) {
  const std::vector<Point> points{{1, 0.1, 0, 1}, {1, 0.1, 1, 1}};
  EXPECT_THAT(pareto_set(points), testing::ElementsAre(true, true));
}

TEST(Trade, TakesTheCheapestRunWithinATolerance) {
  const std::vector<Point> points{{1, 0.1, 0, 1}, {4, 0.02, 0, 0.5}, {2, 0.03, 1, 1}, {9, 0.001, 1, 0.5}};
  EXPECT_EQ(cheapest(points, 0.1), 0U);
  EXPECT_EQ(cheapest(points, 0.03), 2U);
  EXPECT_EQ(cheapest(points, 0.025), 1U);
  EXPECT_EQ(cheapest(points, 0.0001), std::nullopt);
}

TEST(Trade, DoesNotCountAnErrorThatOnlyPassesThroughZero) {
  const std::vector<Point> points{{1, 0.0001, 0, 1}, {4, 0.05, 0, 0.5}, {9, 0.002, 1, 1}};
  EXPECT_EQ(cheapest(points, 0.01), 2U);
}

}  // namespace
}  // namespace trajan::accuracy
