#include "client/scene_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/diagnostics.h"
#include "client/utf8.h"
#include "proto/suggestion.h"

namespace trajan::client {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

auto Mistake(int line, int column, const std::string& message, const std::string& hint) {
  return AllOf(Field(&Diagnostic::position, Position{line, column}),
               Field(&Diagnostic::message, HasSubstr(message)), Field(&Diagnostic::hint, HasSubstr(hint)));
}

v1::Violation violation(const std::string& path, const std::string& problem = "is wrong") {
  v1::Violation result;
  result.set_path(path);
  result.set_problem(problem);
  return result;
}

TEST(SceneText, ReadsTextFormatWithComments) {
  const SceneText text("# a scene\nname: \"bar\"\nbodies { geometry { box { upper { x: 2 } } } }\n",
                       SceneFormat::text);
  EXPECT_THAT(text.diagnostics(), IsEmpty());
  EXPECT_EQ(text.scene().name(), "bar");
  EXPECT_EQ(text.scene().bodies(0).geometry().box().upper().x(), 2.0);
}

TEST(SceneText, ReadsJson) {
  const SceneText text("{\"name\": \"bar\", \"bodies\": [{\"particlesPerCellSide\": 3}]}", SceneFormat::json);
  EXPECT_THAT(text.diagnostics(), IsEmpty());
  EXPECT_EQ(text.scene().bodies(0).particles_per_cell_side(), 3);
}

TEST(SceneText, PointsAtAnUnknownFieldAndSuggestsTheOneThatWasMeant) {
  const SceneText text("name: \"a\"\ndomain {\n  dimensoin: PLANE_STRESS\n}\n", SceneFormat::text);
  EXPECT_THAT(text.diagnostics(),
              ElementsAre(Mistake(3, 3, "no field \"dimensoin\" in \"domain\"", "\"dimension\"")));
}

TEST(SceneText, PointsAtAnUnknownEnumValue) {
  const SceneText text("domain { dimension: PLANE_STRES }", SceneFormat::text);
  EXPECT_THAT(text.diagnostics(),
              ElementsAre(Mistake(1, 21, "\"PLANE_STRES\" is not a value", "\"PLANE_STRESS\"")));
}

TEST(SceneText, ListsTheChoicesIfNoneIsNear) {
  const SceneText text("bodies { geometry { pyramid { } } }", SceneFormat::text);
  EXPECT_THAT(text.diagnostics(), ElementsAre(Mistake(1, 21, "pyramid", "box, disc")));
}

TEST(SceneText, FindsTenMistakesAtOnce) {
  const SceneText text(
      "nmae: \"a\"\n"
      "domain {\n"
      "  dimension: PLANE_STRES\n"
      "  cell_size: large\n"
      "\tthickness: \"1\"\n"
      "}\n"
      "materials { name: steel density: 1 linear_elastic { } neo_hookean { } }\n"
      "bodies { particles_per_cell_side: 2.5 material: \"s\" material: \"t\" }\n"
      "outputs { probes { fields: [STRESS, DISPLACMENT] } snapshot 3 }\n",
      SceneFormat::text);
  EXPECT_THAT(text.diagnostics(), ElementsAre(Mistake(1, 1, "nmae", "\"name\""),                       //
                                              Mistake(3, 14, "PLANE_STRES", "\"PLANE_STRESS\""),       //
                                              Mistake(4, 14, "found large", "write a number"),         //
                                              Mistake(5, 13, "expected number", "write a number"),     //
                                              Mistake(7, 19, "found steel", "in quotes"),              //
                                              Mistake(7, 55, "cannot be given together", "keep one"),  //
                                              Mistake(8, 35, "found 2.5", "whole number"),             //
                                              Mistake(8, 53, "given twice", "keep one"),               //
                                              Mistake(9, 37, "DISPLACMENT", "\"DISPLACEMENT\""),       //
                                              Mistake(9, 52, "no field \"snapshot\"", "\"snapshots\"")));
}

TEST(SceneText, KeepsWhatCouldBeRead) {
  const SceneText text("name: \"a\"\nunits: 5\nbodies { name: \"b\" colour: 3 }", SceneFormat::text);
  EXPECT_THAT(text.diagnostics(), SizeIs(2));
  EXPECT_EQ(text.scene().name(), "a");
  EXPECT_EQ(text.scene().bodies(0).name(), "b");
}

TEST(SceneText, PointsAtABracketThatIsNeverClosed) {
  const SceneText text("name: \"a\"\ndomain {\n  lower { x: 1 }\n", SceneFormat::text);
  EXPECT_THAT(text.diagnostics(), ElementsAre(Mistake(2, 8, "never closed", "")));
  EXPECT_FALSE(text.has_structure());
}

TEST(SceneText, PointsAtABracketThatClosesNothing) {
  const SceneText text("domain { }\n}\n", SceneFormat::text);
  EXPECT_THAT(text.diagnostics(), ElementsAre(Mistake(2, 1, "closes nothing", "")));
}

TEST(SceneText, RefusesDeepNesting) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "a{";
  EXPECT_THAT(SceneText(deep, SceneFormat::text).diagnostics(), ElementsAre(Mistake(1, 202, "nested deeper", "")));
  deep.clear();
  for (int i = 0; i < 100'000; ++i) deep += "{\"a\":";
  EXPECT_THAT(SceneText(deep, SceneFormat::json).diagnostics(), SizeIs(1));
}

TEST(SceneText, PointsAtTheByteThatIsNotUtf8) {
  const SceneText text("name: \"a\"\n# Tr\xe4ger\nbodies { }\n", SceneFormat::text);
  EXPECT_THAT(text.diagnostics(), ElementsAre(Mistake(2, 5, "0xE4 is not valid UTF-8", "iconv")));
  EXPECT_FALSE(text.has_structure());
  EXPECT_EQ(format_diagnostic(text.diagnostics().at(0), text, "a", false),
            "a:2:5: error: the byte 0xE4 is not valid UTF-8\n"
            "    2 | # Tr?ger\n"
            "      |     ^\n"
            "      = hint: save the scene as UTF-8; from Latin-1: iconv -f latin1 -t utf-8\n");
}

TEST(SceneText, AcceptsUtf8AndRefusesEscapesThatMakeSomethingElse) {
  EXPECT_THAT(SceneText("name: \"Tr\xc3\xa4ger \\303\\244 \\u00e4\"", SceneFormat::text).diagnostics(), IsEmpty());
  EXPECT_THAT(SceneText("{\"name\": \"\\u00e4 \\ud83d\\ude00\"}", SceneFormat::json).diagnostics(), IsEmpty());
  EXPECT_THAT(SceneText("name: \"\\xe4\"", SceneFormat::text).diagnostics(),
              ElementsAre(Mistake(1, 7, "not UTF-8", "\\u00e4")));
}

TEST(Utf8, IsWhatTheStandardSays) {
  for (const char* good : {"", "a", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xef\xbf\xbf",
                           "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"}) {
    EXPECT_EQ(first_invalid_utf8(good), std::string_view::npos);
  }
  // A stray continuation, overlong forms, surrogates, beyond U+10FFFF, and characters that are cut off.
  for (const char* bad :
       {"\x80", "\xc0\xaf", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80",
        "\xf5\x80\x80\x80", "\xff", "\xc3", "\xe4\xbd", "\xf0\x9f\x98", "\xc3z"}) {
    EXPECT_EQ(first_invalid_utf8(std::string("ab") + bad), 2u);
  }
}

TEST(SceneText, RefusesWhatIsTooLarge) {
  const SceneText text(std::string(SceneText::max_bytes + 1, ' '), SceneFormat::text);
  EXPECT_THAT(text.diagnostics(), ElementsAre(Mistake(0, 0, "bytes", "at most")));
}

TEST(SceneText, SurvivesVeryLongWords) {
  const std::string word(1'000'000, 'a');
  EXPECT_THAT(SceneText("name: " + word, SceneFormat::text).diagnostics(), SizeIs(1));
  EXPECT_THAT(SceneText("domain { dimension: " + word + " }", SceneFormat::text).diagnostics(), SizeIs(1));
  EXPECT_THAT(SceneText(word, SceneFormat::text).diagnostics(), SizeIs(1));
  EXPECT_THAT(SceneText("{\"" + word + "\": 1}", SceneFormat::json).diagnostics(), SizeIs(1));
}

TEST(SceneText, LocatesTheValueOfAViolation) {
  const SceneText text("bodies { }\nbodies {\n  geometry { disc { radius: -1 } }\n}\n", SceneFormat::text);
  EXPECT_EQ(text.locate(violation("bodies[1].geometry.disc.radius")).position, (Position{3, 29}));
}

TEST(SceneText, SaysTheValueOfAViolationOnce) {
  const SceneText text("bodies { }", SceneFormat::text);
  v1::Violation wrong = violation("bodies[0].material", "there is no material \"stel\"");
  wrong.set_value("stel");
  EXPECT_EQ(text.locate(wrong).message, "bodies[0].material: there is no material \"stel\"");
  wrong.set_problem("out of range");
  EXPECT_EQ(text.locate(wrong).message, "bodies[0].material: out of range (got stel)");
}

TEST(SceneText, LocatesElementsOfLists) {
  const SceneText text(
      "loads { time { table { times: [0, 2, 1] } } }\nmeasures: [{ name: \"a\" }, { name: \"b\" }]",
      SceneFormat::text);
  EXPECT_EQ(text.locate(violation("loads[0].time.table.times[2]")).position, (Position{1, 38}));
  EXPECT_EQ(text.locate(violation("measures[1].name")).position, (Position{2, 35}));
}

TEST(SceneText, LocatesAMissingFieldAtItsNearestAncestor) {
  const SceneText text("name: \"a\"\nbodies {\n  geometry { disc { } }\n}\n", SceneFormat::text);
  EXPECT_EQ(text.locate(violation("bodies[0].geometry.disc.radius")).position, (Position{3, 14}));
  EXPECT_EQ(text.locate(violation("domain")).position, Position{});
}

TEST(SceneText, LocatesFieldsOfJson) {
  const SceneText text("{\n \"bodies\": [\n  {\"particlesPerCellSide\": 99}]}", SceneFormat::json);
  EXPECT_EQ(text.locate(violation("bodies[0].particles_per_cell_side")).position, (Position{3, 28}));
}

TEST(SceneText, PointsAtAnUnknownFieldOfJson) {
  const SceneText text("{\n \"domain\": {\"cel_size\": 1}}", SceneFormat::json);
  EXPECT_THAT(text.diagnostics(), ElementsAre(Mistake(2, 13, "cel_size", "\"cell_size\"")));
}

TEST(SceneText, LeavesOutViolationsThatFollowFromAMisspeltField) {
  const SceneText text("domain { cel_size: 1 }\nbodies { }", SceneFormat::text);
  google::protobuf::RepeatedPtrField<v1::Violation> violations;
  *violations.Add() = violation("domain.cell_size", "must be > 0");
  *violations.Add() = violation("bodies[0].name", "is missing");
  EXPECT_THAT(text.merge(violations),
              ElementsAre(Mistake(1, 10, "cel_size", ""), Mistake(2, 1, "is missing", "")));
}

TEST(Diagnostics, ShowTheLineWithACaret) {
  const SceneText text("domain {\n\tdimension: PLANE_STRES\n}", SceneFormat::text);
  EXPECT_EQ(format_diagnostic(text.diagnostics().at(0), text, "a.textproto", false),
            "a.textproto:2:13: error: \"PLANE_STRES\" is not a value of dimension\n"
            "    2 | \tdimension: PLANE_STRES\n"
            "      | \t           ^~~~~~~~~~~\n"
            "      = hint: did you mean \"PLANE_STRESS\"?\n");
}

TEST(Diagnostics, DoNotSendControlCharactersToTheTerminal) {
  const SceneText text("name: \"\033[2J\" nmae: 1", SceneFormat::text);
  for (const Diagnostic& diagnostic : text.diagnostics()) {
    EXPECT_EQ(format_diagnostic(diagnostic, text, "a", false).find('\033'), std::string::npos);
  }
}

TEST(Suggestion, CountsASwapOfNeighboursAsOneEdit) {
  EXPECT_EQ(edit_distance("dimensoin", "dimension"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("Kitten", "sitting"), 3);
}

TEST(Suggestion, IsSilentWhenNothingIsNear) {
  EXPECT_EQ(nearest_word("pyramid", {"box", "disc"}), "");
  EXPECT_EQ(nearest_word("dics", {"box", "disc"}), "disc");
}

}  // namespace
}  // namespace trajan::client
