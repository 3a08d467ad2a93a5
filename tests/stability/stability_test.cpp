#include <gtest/gtest.h>

#include "tests/stability/extremes.h"
#include "tests/stability/luck.h"

namespace trajan::stability {
namespace {

class Stability : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Extremes, Stability, testing::ValuesIn(cases()),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST_P(Stability, EveryRunHoldsItsBoundOrSaysWhyNot) {
  for (const Extreme& extreme : GetParam().extremes(Size::quick)) {
    const Row row = judge(extreme);
    EXPECT_NE(row.verdict, Verdict::wrong)
        << extreme.name << ": " << extreme.claim << " is " << row.figure.value_or(0) << ", at most "
        << extreme.bound << " is right; " << row.diagnosis;
  }
}

TEST(Luck, RandomScenesKeepTheirPromisesOrSayWhyNot) { EXPECT_TRUE(try_luck(50)); }

}  // namespace
}  // namespace trajan::stability
