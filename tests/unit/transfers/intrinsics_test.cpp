#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "solver/transfers/eight_lanes.h"
#include "solver/transfers/find_ends.h"
#include "solver/transfers/masks.h"
#include "solver/transfers/vectors.h"

/// What names instructions against what it says in plain code.
namespace trajan::test {
namespace {

template <class Vector>
constexpr int lanes_in = sizeof(Vector) / sizeof(std::declval<Vector&>()[0]);

/// A vector whose lane i is of(i).
template <class Vector, class Of>
Vector made(Of&& of) {
  std::remove_cvref_t<decltype(std::declval<Vector&>()[0])> numbers[lanes_in<Vector>];
  for (int i = 0; i < lanes_in<Vector>; ++i) numbers[i] = of(i);
  return load<Vector>(numbers);
}

template <class Vector>
class MultiplyAdd : public testing::Test {};
using Vectors = testing::Types<Pair, Four, Eight, Twice<Pair>, Twice<Four>>;
TYPED_TEST_SUITE(MultiplyAdd, Vectors);

TYPED_TEST(MultiplyAdd, IsTheProductPlusTheTermInEveryLaneRoundedOnceOrTwice) {
  const auto a = made<TypeParam>([](int i) { return static_cast<Real>(1.1 + i); }),
             b = made<TypeParam>([](int i) { return static_cast<Real>(0.3 - i); }),
             c = made<TypeParam>([](int i) { return static_cast<Real>(7.7 * i - 2); });
  const TypeParam sum = multiply_add(a, b, c);
  for (int i = 0; i < lanes_in<TypeParam>; ++i) {
    const Real once = std::fma(a[i], b[i], c[i]);
    const volatile Real product = a[i] * b[i];
    EXPECT_TRUE(sum[i] == once || sum[i] == product + c[i]) << i;
  }
}

TEST(TwiceARegister, ReckonsInEveryLane) {
  using Vector = Twice<Four>;
  const auto a = made<Vector>([](int i) { return static_cast<Real>(1.1 + i); }),
             b = made<Vector>([](int i) { return static_cast<Real>(0.3 - i); });
  Vector sum = a, product = a;
  sum += b;
  product *= b;
  for (int i = 0; i < lanes_in<Vector>; ++i) {
    EXPECT_EQ(sum[i], a[i] + b[i]) << i;
    EXPECT_EQ(product[i], a[i] * b[i]) << i;
    EXPECT_EQ((a * Real{3})[i], a[i] * Real{3}) << i;
    EXPECT_EQ((Real{3} * a)[i], a[i] * Real{3}) << i;
    EXPECT_EQ((Real{3} - a)[i], Real{3} - a[i]) << i;
    EXPECT_EQ((-a)[i], -a[i]) << i;
  }
  double sums[8] = {1, 2, 3, 4, 5, 6, 7, 8};
  add(sums, a);
  for (int i = 0; i < lanes_in<Vector>; ++i) EXPECT_EQ(sums[i], 1 + i + static_cast<double>(a[i])) << i;
}

TEST(Spread, HasTheNumberInEveryLaneWithItsSign) {
  const Eight zero = spread<Eight>(Real{-0.0});
  for (int i = 0; i < 8; ++i) EXPECT_TRUE(std::signbit(zero[i])) << i;
  EXPECT_EQ(spread<Four>(Real{3.5})[3], Real{3.5});
}

template <class Vector>
class LanesFromOne : public testing::Test {};
using Registers = testing::Types<Pair, Four>;
TYPED_TEST_SUITE(LanesFromOne, Registers);

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
  expect_lanes<Twice<Rows4>, 0, 3>();
  expect_lanes<Twice<Rows4>, 3, 6>();
  expect_lanes<Twice<Rows4>, 7, 8>();
}

TEST(Converted, KeepsFloatsInTheirLanes) {
  const VectorOf<float, 4>::Type four{1, 2.5F, -3, 4};
  const VectorOf<float, 8>::Type eight{1, 2.5F, -3, 4, 5, 6, 7, -0.125F};
  for (int lane = 0; lane < 4; ++lane) EXPECT_EQ(converted<double>(four)[lane], four[lane]) << lane;
  for (int lane = 0; lane < 8; ++lane) EXPECT_EQ(converted<double>(eight)[lane], eight[lane]) << lane;
}

/// Those that find_ends gives are those of all indices at which is_end(value before, value) is true.
template <class At, class IsEnd>
void expect_ends(const std::vector<std::int32_t>& values, IsEnd&& is_end) {
  std::vector<std::int32_t> expected;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (is_end(values[i - 1], values[i])) expected.push_back(static_cast<std::int32_t>(i));
  std::vector<std::int32_t> found(values.size() + 16, -1);
  const int count = find_ends<At>(values.data(), static_cast<int>(values.size()), found.data());
  found.resize(static_cast<std::size_t>(count));
  EXPECT_EQ(found, expected) << testing::PrintToString(values);
}

TEST(FindEnds, FindsTheFirstOfEveryRunOfEqualValuesWhateverTheirNumber) {
  for (int count = 1; count < 40; ++count)
    for (int period = 1; period < 12; ++period) {
      std::vector<std::int32_t> values;
      for (int i = 0; i < count; ++i) values.push_back(i / period % 3);
      expect_ends<Changes>(values, std::not_equal_to<>());
    }
}

TEST(FindEnds, FindsWhereValuesNoLongerGrowOrAreOfAnotherRow) {
  constexpr int row = 11;
  std::mt19937 random(3);
  std::uniform_int_distribution<std::int32_t> step(-1, 5);
  for (int count = 1; count < 150; ++count) {
    std::vector<std::int32_t> values{0};
    for (int i = 1; i < count; ++i) values.push_back(std::clamp(values.back() + step(random), 0, row * row - 1));
    expect_ends<RiseEnds<row>>(values,
                               [](int before, int now) { return now <= before || now / row != before / row; });
  }
}

TEST(EightLanes, ArePutInAnotherOrderReadInPartAndCounted) {
  EightFloats values;
  EightLanes from;
  for (int lane = 0; lane < 8; ++lane) values[lane] = 0.5F + static_cast<float>(lane), from[lane] = 5 * lane + 3;
  const EightFloats moved = permuted(values, from);
  for (int lane = 0; lane < 8; ++lane) EXPECT_EQ(moved[lane], values[(5 * lane + 3) % 8]) << lane;
  for (std::int32_t bits = 0; bits < 256; ++bits) {
    const EightLanes lanes = lanes_of(bits), before = count_lanes_before(bits);
    const std::vector<float> only(static_cast<std::size_t>(std::bit_width(static_cast<std::uint32_t>(bits))),
                                  2.5F);
    const EightFloats read = load_only(only.data(), lanes);
    int count = 0;
    for (int lane = 0; lane < 8; ++lane) {
      const bool set = bits >> lane & 1;
      EXPECT_EQ(lanes[lane], set ? -1 : 0) << bits << ' ' << lane;
      EXPECT_EQ(read[lane], set ? 2.5F : 0.0F) << bits << ' ' << lane;
      EXPECT_EQ(before[lane], count) << bits << ' ' << lane;
      count += set;
    }
    EXPECT_EQ(sum_of_lanes(lanes), -count) << bits;
    EXPECT_EQ(any_bit(lanes & 4), bits != 0) << bits;
  }
}

}  // namespace
}  // namespace trajan::test
