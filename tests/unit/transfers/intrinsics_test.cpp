#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "solver/transfers/masks.h"
#include "solver/transfers/vectors.h"

/// What names instructions against what it says in plain code.
namespace trajan::test {
namespace {

template <class Vector>
class MultiplyAdd : public testing::Test {};
using Vectors = testing::Types<Pair, Four, Eight>;
TYPED_TEST_SUITE(MultiplyAdd, Vectors);

TYPED_TEST(MultiplyAdd, IsTheProductPlusTheTermInEveryLaneRoundedOnceOrTwice) {
  TypeParam a, b, c;
  const int lanes = sizeof a / sizeof a[0];
  for (int i = 0; i < lanes; ++i) {
    a[i] = static_cast<Real>(1.1 + i);
    b[i] = static_cast<Real>(0.3 - i);
    c[i] = static_cast<Real>(7.7 * i - 2);
  }
  const TypeParam sum = multiply_add(a, b, c);
  for (int i = 0; i < lanes; ++i) {
    const Real once = std::fma(a[i], b[i], c[i]);
    const volatile Real product = a[i] * b[i];
    EXPECT_TRUE(sum[i] == once || sum[i] == product + c[i]) << i;
  }
}

TEST(Spread, HasTheNumberInEveryLaneWithItsSign) {
  const Eight zero = spread<Eight>(Real{-0.0});
  for (int i = 0; i < 8; ++i) EXPECT_TRUE(std::signbit(zero[i])) << i;
  EXPECT_EQ(spread<Four>(Real{3.5})[3], Real{3.5});
}

template <class Vector>
class LanesFromOne : public testing::Test {};
TYPED_TEST_SUITE(LanesFromOne, Vectors);

TYPED_TEST(LanesFromOne, GetTheNumberAndNoOthers) {
  const int lanes = sizeof(TypeParam) / sizeof(Real);
  const Real number = 7;
  for (int first = 0; first <= lanes; ++first) {
    const TypeParam some = LanesFrom<TypeParam>(first).put(&number, spread<TypeParam>(Real{3}));
    for (int i = 0; i < lanes; ++i) EXPECT_EQ(some[i], i < first ? Real{3} : number) << first << ' ' << i;
  }
}

template <class Vector, int first, int end>
void expect_lanes() {
  // Nothing but these may be read.
  std::vector<double> numbers;
  for (int lane = first; lane < end; ++lane) numbers.push_back(lane + 0.5);
  const Vector lanes = load_lanes<Vector, first, end>(numbers.data() - first);
  for (int lane = 0; lane < static_cast<int>(sizeof lanes / sizeof lanes[0]); ++lane)
    EXPECT_EQ(lanes[lane], lane < first || lane >= end ? 0 : lane + 0.5) << first << ' ' << end << ' ' << lane;
}

TEST(LoadLanes, ReadsTheseAlone) {
  using Rows4 = VectorOf<double, 4>::Type;
  using Rows8 = VectorOf<double, 8>::Type;
  expect_lanes<Rows4, 0, 2>();
  expect_lanes<Rows4, 0, 3>();
  expect_lanes<Rows4, 2, 4>();
  expect_lanes<Rows4, 3, 4>();
  expect_lanes<Rows8, 0, 2>();
  expect_lanes<Rows8, 0, 3>();
  expect_lanes<Rows8, 6, 8>();
  expect_lanes<Rows8, 7, 8>();
}

TEST(Converted, KeepsFloatsInTheirLanes) {
  const VectorOf<float, 4>::Type four{1, 2.5F, -3, 4};
  const VectorOf<float, 8>::Type eight{1, 2.5F, -3, 4, 5, 6, 7, -0.125F};
  for (int lane = 0; lane < 4; ++lane) EXPECT_EQ(converted<double>(four)[lane], four[lane]) << lane;
  for (int lane = 0; lane < 8; ++lane) EXPECT_EQ(converted<double>(eight)[lane], eight[lane]) << lane;
}

TEST(FindChanges, FindsTheFirstOfEveryRunOfEqualValuesWhateverTheirNumber) {
  for (int count = 1; count < 40; ++count)
    for (int period = 1; period < 12; ++period) {
      std::vector<std::int32_t> values, expected;
      for (int i = 0; i < count; ++i) {
        values.push_back(i / period % 3);
        if (i > 0 && values[i] != values[i - 1]) expected.push_back(i);
      }
      std::vector<std::int32_t> found(values.size() + 16, -1);
      found.resize(static_cast<std::size_t>(find_changes(values.data(), count, found.data())));
      EXPECT_EQ(found, expected) << count << ' ' << period;
    }
}

}  // namespace
}  // namespace trajan::test
