#include "solver/model/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace trajan {
namespace {

using testing::HasSubstr;

/// What is wrong, then what would be right.
std::string complaint(const std::string& text, const std::string& variables = "xyt",
                      const Constants& constants = {}) {
  try {
    Expression expression(text, variables, constants);
  } catch (const FormulaError& error) {
    return std::string(error.what()) + "; " + error.remedy();
  }
  return "";
}

double value(const std::string& text, double x = 0, double y = 0, double t = 0) {
  return Expression(text, "xyt", {{"E", 3000}, {"e5", 7}})(x, y, t);
}

TEST(Expression, HasTheValueOfItsFormula) {
  EXPECT_DOUBLE_EQ(value("2 * x + y^2 - t / 4", 3, 2, 8), 8);
  EXPECT_DOUBLE_EQ(value("sin(pi / 2) * E"), 3000);
  EXPECT_DOUBLE_EQ(value("x < 1 ? 5 : 6", 0), 5);
  EXPECT_DOUBLE_EQ(value("x >= 1 && y != 2 ? 5 : 6", 1, 1), 5);
  EXPECT_DOUBLE_EQ(value("-2^2"), -4);
}

TEST(Expression, TellsExponentsFromNames) {
  EXPECT_DOUBLE_EQ(value("1e5"), 1e5);
  EXPECT_DOUBLE_EQ(value("2.5E-3 + e5"), 7.0025);
}

TEST(Expression, IsNotFiniteWhereTheFormulaIsNotDefined) {
  EXPECT_FALSE(std::isfinite(value("1 / x")));
  EXPECT_TRUE(std::isnan(value("sqrt(x)", -1)));
  EXPECT_FALSE(std::isfinite(value("log(x)")));
}

TEST(Expression, CopiesShareNothing) {
  const Expression original("x * E", "x", {{"E", 2}});
  const Expression copy = original;
  EXPECT_EQ(original(3, 0, 0), 6);
  EXPECT_EQ(copy(4, 0, 0), 8);
  EXPECT_EQ(original(3, 0, 0), 6);
  EXPECT_EQ(copy.text(), "x * E");
}

TEST(Expression, NamesWhatItDoesNotKnowAndWhere) {
  const std::string text = complaint("2 * lenght", "t", {{"length", 1}});
  EXPECT_THAT(text, HasSubstr("\"lenght\""));
  EXPECT_THAT(text, HasSubstr("did you mean \"length\"?"));
  EXPECT_THAT(text, HasSubstr("at character 5"));
  EXPECT_THAT(complaint("2 * (1 + )"), HasSubstr("at character 10: unexpected parenthesis"));
  EXPECT_THAT(complaint("x + t", "x"), HasSubstr("\"t\" has no meaning here"));
  EXPECT_THAT(complaint("cosh(sim(t))"), HasSubstr("did you mean \"sin\"?"));
}

TEST(Expression, RefusesWhatIsNotAFormulaWithOneValue) {
  for (const char* text :
       {"",      "  ",    "1 +",   "(1",      "1)",       "sin(", "sin()", "sin",    "sin(1, 2)", "1, 2", "2 x",
        "1 ? 2", "1 : 2", "t = 5", "x = = 2", "\"text\"", "1e",   "1..2",  "2 ** 3", "#",         "\xff", "a\0b",
        "_pi",   "1e999", "!x",    "x!",      "x;y",      "()",   ",",     "?:",     "min()"}) {
    EXPECT_NE(complaint(text), "") << text;
  }
}

TEST(Expression, RefusesFormulasThatAreTooLongOrTooDeep) {
  std::string sum = "1";
  while (sum.size() + 2 <= Expression::longest) sum += "+1";
  EXPECT_EQ(complaint(sum), "");
  EXPECT_THAT(complaint(sum + "+1"), HasSubstr("1025 characters"));
  const std::string open(Expression::deepest, '('), close(Expression::deepest, ')');
  EXPECT_EQ(complaint(open + "1" + close), "");
  EXPECT_THAT(complaint("(" + open + "1" + close + ")"), HasSubstr("nested too deeply"));
  EXPECT_THAT(complaint(std::string(1'000'000, '(')), HasSubstr("1000000 characters"));
}

TEST(Expression, KeepsTheMeaningsThatFormulasGiveToNames) {
  for (const char* name : {"x", "y", "z", "t", "pi", "sin", "sqrt"}) EXPECT_TRUE(is_reserved_in_expressions(name));
  EXPECT_FALSE(is_reserved_in_expressions("E"));
  // A constant may be called like nothing else; one that is not used costs nothing.
  EXPECT_EQ(Expression("E", "", {{"E", 1}, {"not a name", 2}})(0, 0, 0), 1);
}

}  // namespace
}  // namespace trajan
