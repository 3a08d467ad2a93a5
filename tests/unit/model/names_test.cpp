#include "solver/model/names.h"

#include <gtest/gtest.h>

#include <limits>

namespace trajan {
namespace {

TEST(Names, HintIsTheNearestNameIfOneIsNear) {
  const std::vector<std::string> schemes = {"MUSL", "USL", "TLMPM"};
  EXPECT_EQ(did_you_mean("MULS", schemes), "did you mean \"MUSL\"?");
  EXPECT_EQ(did_you_mean("MXSX", schemes), "");
  EXPECT_EQ(did_you_mean("MUSLE", schemes), "did you mean \"MUSL\"?");
  EXPECT_EQ(did_you_mean("tlmpm", schemes), "did you mean \"TLMPM\"?");
  EXPECT_EQ(did_you_mean("leapfrog", schemes), "");
  EXPECT_EQ(did_you_mean("", schemes), "");
  EXPECT_EQ(did_you_mean(std::string(1'000'000, 'M'), schemes), "");
}

TEST(Names, ListsBeginWithWhatWasMeant) {
  const std::vector<std::string> columns = {"momentum.x", "beam.stress.xx", "tip.velocity.y", "tip.position.y"};
  EXPECT_EQ(nearest_first("tip.velocty.y", columns).front(), "tip.velocity.y");
  EXPECT_EQ(nearest_first("stress", columns).front(), "beam.stress.xx");
  EXPECT_EQ(nearest_first("", columns), columns);
}

TEST(Names, LongTextsAreCutBetweenCharacters) {
  EXPECT_EQ(shortened(std::string(80, 'a')), std::string(80, 'a'));
  EXPECT_EQ(shortened(std::string(79, 'a') + "\xc3\xa4"), std::string(79, 'a') + "...");
}

TEST(Names, NumbersAreTheShortestThatReadBack) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-1e300), "-1e+300");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(point_text({1, -2.5}, 2), "(1, -2.5)");
  EXPECT_EQ(point_text({1, 2.5, -3}, 3), "(1, 2.5, -3)");
  EXPECT_EQ(point_text({1, 0, 0}, 1), "(1)");
}

TEST(Names, IdentifiersAreSafeInPathsAndColumns) {
  EXPECT_TRUE(is_identifier("tip_2-b"));
  for (const char* name : {"", "a.b", "a/b", "a b", "\xc3\xa4"}) EXPECT_FALSE(is_identifier(name)) << name;
  EXPECT_TRUE(is_identifier(std::string(64, 'a')));
  EXPECT_FALSE(is_identifier(std::string(65, 'a')));
}

}  // namespace
}  // namespace trajan
