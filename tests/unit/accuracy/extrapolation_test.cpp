#include "solver/accuracy/extrapolation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace trajan::accuracy {
namespace {

std::vector<Level> series(const std::vector<double>& cell_sizes, double exact, double factor, double order) {
  std::vector<Level> levels;
  for (const double h : cell_sizes) levels.push_back({h, exact + factor * std::pow(h, order)});
  return levels;
}

// Of a difference of two values near 3 that is as small as 1e-3, 12 digits are left: the order has 1e-11 or so.
constexpr double order_tolerance = 1e-9;

TEST(Extrapolation, FindsTheOrderAndTheLimitOfAPowerSeriesForAnyRatios) {
  for (const double order : {0.6, 1.0, 1.7, 2.0}) {
    for (const auto& sizes : {std::vector{1.0, 0.5, 0.25}, {1.0, 0.7, 0.5}, {0.9, 0.5, 0.4}, {8.0, 4.0, 1.0}}) {
      const auto levels = series(sizes, 3, -0.2, order);
      const Estimate found = estimate(levels);
      EXPECT_EQ(found.behaviour, Behaviour::monotone);
      ASSERT_TRUE(found.order.has_value());
      EXPECT_NEAR(*found.order, order, order_tolerance);
      EXPECT_NEAR(*found.extrapolated, 3, order_tolerance);
      EXPECT_GE(*found.band, std::abs(levels.back().value - 3)) << order;
    }
  }
}

TEST(Extrapolation, IsAsymptoticNearTheExpectedOrderOnly) {
  EXPECT_TRUE(estimate(series({1, 0.5, 0.25}, 3, 1, 2)).asymptotic);
  EXPECT_TRUE(estimate(series({1, 0.5, 0.25}, 3, 1, 1.85)).asymptotic);
  EXPECT_FALSE(estimate(series({1, 0.5, 0.25}, 3, 1, 1)).asymptotic) << "three levels cannot know";
  EXPECT_TRUE(estimate(series({1, 0.5, 0.25, 0.125}, 3, 1, 1)).asymptotic) << "four have seen it twice";
}

TEST(Extrapolation, IsMoreCautiousOutsideTheAsymptoticRange) {
  const auto first_order = series({1, 0.5, 0.25}, 3, 1, 1);
  EXPECT_NEAR(*estimate(first_order).band, 3 * 0.25, 1e-9) << "three times the true error";
  const auto second_order = series({1, 0.5, 0.25}, 3, 1, 2);
  EXPECT_NEAR(*estimate(second_order).band, 2 * 0.0625, 1e-9) << "twice the true error";
}

// Nothing converges faster than the expected order for long: a fast beginning is no reason for a small band.
TEST(Extrapolation, TrustsNoOrderAboveTheFirstOutsideTheAsymptoticRange) {
  const auto fast = series({1, 0.5, 0.25}, 3, 1, 5);
  EXPECT_NEAR(*estimate(fast).order, 5, order_tolerance);
  EXPECT_NEAR(*estimate(fast).band, 3 * std::abs(fast[2].value - fast[1].value), 1e-12)
      << "3 / (2 - 1) differences";
}

TEST(Extrapolation, CoversAnAlternatingSeriesWithoutExtrapolatingIt) {
  const std::vector<Level> levels{{1, 3 - 0.4}, {0.5, 3 + 0.1}, {0.25, 3 - 0.025}};
  const Estimate found = estimate(levels);
  EXPECT_EQ(found.behaviour, Behaviour::oscillating);
  EXPECT_NEAR(*found.order, 2, order_tolerance);
  EXPECT_FALSE(found.asymptotic);
  EXPECT_EQ(*found.extrapolated, levels.back().value);
  EXPECT_NEAR(*found.band, 3 * 0.5, 1e-12) << "of the difference before the last";
}

void expect_no_claim(const std::vector<Level>& levels, Behaviour behaviour) {
  const Estimate found = estimate(levels);
  EXPECT_EQ(found.behaviour, behaviour);
  EXPECT_FALSE(found.band.has_value());
  EXPECT_FALSE(found.extrapolated.has_value());
  EXPECT_FALSE(found.asymptotic);
  EXPECT_NE(found.no_claim, "");
}

TEST(Extrapolation, ClaimsNothingOfWhatDoesNotConverge) {
  expect_no_claim({{1, 1}, {0.5, 2}, {0.25, 4}}, Behaviour::not_converging);
  expect_no_claim({{1, 1}, {0.5, 2}, {0.25, 3}}, Behaviour::not_converging);
  expect_no_claim({{1, 1}, {0.5, 1.1}, {0.25, 0.8}}, Behaviour::not_converging);
  expect_no_claim({{1, 1}, {0.5, 2}, {0.25, std::nan("")}}, Behaviour::not_converging);
  expect_no_claim({{1, 1}, {0.5, 2}, {0.25, std::numeric_limits<double>::infinity()}}, Behaviour::not_converging);
}

TEST(Extrapolation, ClaimsNothingOfSlowConvergence) {
  expect_no_claim(series({1, 0.5, 0.25}, 3, 1, 0.3), Behaviour::monotone);
}

TEST(Extrapolation, ClaimsNothingOfDifferencesOfZeroOrOfRounding) {
  expect_no_claim({{1, 3}, {0.5, 3}, {0.25, 3}}, Behaviour::constant);
  expect_no_claim({{1, 0}, {0.5, 0}, {0.25, 0}}, Behaviour::constant);
  expect_no_claim({{1, 3}, {0.5, 3 + 4e-15}, {0.25, 3 + 5e-15}}, Behaviour::constant);
  expect_no_claim({{1, 3}, {0.5, 2}, {0.25, 2}}, Behaviour::not_converging);
  expect_no_claim({{1, 3}, {0.5, 3}, {0.25, 2}}, Behaviour::not_converging);
}

TEST(Extrapolation, DoesNotDependOnUnits) {
  const std::vector<Level> levels{{1, 3.3}, {0.5, 3.1}, {0.25, 3.04}};
  std::vector<Level> scaled;
  for (const Level& level : levels) scaled.push_back({level.cell_size * 1024, level.value / 4096});
  EXPECT_EQ(*estimate(scaled).order, *estimate(levels).order);
  EXPECT_EQ(*estimate(scaled).band, *estimate(levels).band / 4096);
}

}  // namespace
}  // namespace trajan::accuracy
