#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <sstream>

#include "client/exact_histories.h"
#include "client/gnuplot.h"
#include "client/history_text.h"
#include "client/job_table.h"
#include "client/progress_display.h"
#include "client/submission.h"
#include "client/table.h"
#include "client/terminal.h"
#include "client/unit_labels.h"

namespace trajan::client {
namespace {

std::string printed(const Table& table, OutputFormat format) {
  std::ostringstream out;
  print_table(out, table, format);
  return out.str();
}

const Table mixed{
    {"name", "exact_value"},
    {{std::string("a,\"b\""), 0.1}, {std::string("ü"), std::int64_t{12345678}}, {std::monostate(), {}}}};

TEST(Table, AlignsTextLeftAndNumbersRightForPeople) {
  EXPECT_EQ(printed(mixed, OutputFormat::table),
            "NAME   EXACT VALUE\n"
            "a,\"b\"          0.1\n"
            "ü         12345678\n"
            "-                -\n");
}

TEST(Table, QuotesCsvWhereItMust) {
  EXPECT_EQ(printed(mixed, OutputFormat::csv), "name,exact_value\n\"a,\"\"b\"\"\",0.1\nü,12345678\n,\n");
}

TEST(Table, WritesJsonThatHasNullForNothing) {
  EXPECT_EQ(printed(mixed, OutputFormat::jsonl),
            "{\"name\": \"a,\\\"b\\\"\", \"exact_value\": 0.1}\n"
            "{\"name\": \"ü\", \"exact_value\": 12345678}\n"
            "{\"name\": null, \"exact_value\": null}\n");
  EXPECT_EQ(printed({{"a"}, {}}, OutputFormat::json), "[]\n");
}

TEST(Table, HasNoNumbersInJsonThatJsonDoesNotKnow) {
  EXPECT_EQ(json_number(std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(json_number(std::numeric_limits<double>::quiet_NaN()), "null");
}

TEST(Table, GivesNumbersThatReadBackToTheSameBits) {
  const double third = 1.0 / 3.0;
  EXPECT_EQ(std::stod(json_number(third)), third);
}

TEST(HistoryText, HasTheShortestNumbersThatReadBackAndNullWhereJsonKnowsNone) {
  const std::vector<double> time = {0.5, 1.0 / 3.0};
  const std::vector<double> values = {-std::numeric_limits<double>::max(), -std::numeric_limits<double>::min(),
                                      std::numeric_limits<double>::infinity(), 2};
  const HistoryRows rows{1'000'000, time, values};
  HistoryText csv(OutputFormat::csv, {"a", "b,c"});
  EXPECT_EQ(csv.heading(), "time,a,\"b,c\"\n");
  EXPECT_EQ(csv.lines(rows),
            "0.5,-1.7976931348623157e+308,-2.2250738585072014e-308\n"
            "0.3333333333333333,inf,2\n");
  HistoryText json(OutputFormat::jsonl, {"a", "b,c"});
  EXPECT_EQ(json.lines(rows),
            "{\"row\":1000000,\"time\":0.5,\"a\":-1.7976931348623157e+308,\"b,c\":-2.2250738585072014e-308}\n"
            "{\"row\":1000001,\"time\":0.3333333333333333,\"a\":null,\"b,c\":2}\n");
}

TEST(MeasureTable, JudgesTheErrorByTheTolerance) {
  v1::Job job;
  for (const double error : {0.01, -0.03}) {
    v1::MeasureValue& measure = *job.add_measures();
    measure.set_error(error);
    measure.set_tolerance(0.02);
  }
  job.add_measures()->set_value(1);
  const Table table = measure_table(job);
  EXPECT_EQ(std::get<std::string>(table.rows[0].back()), "ok");
  EXPECT_EQ(std::get<std::string>(table.rows[1].back()), "off");
  EXPECT_TRUE(std::holds_alternative<std::monostate>(table.rows[2].back()));
}

TEST(DescribeJob, SaysWhyARunFailedAndWhatToDo) {
  v1::Job job;
  job.set_job_id("j");
  job.set_scene_name("beam");
  job.set_state(v1::FAILED);
  job.mutable_progress()->set_time(0.5);
  job.mutable_progress()->set_end_time(2);
  job.mutable_progress()->set_step(10);
  job.mutable_progress()->set_total_steps(40);
  job.mutable_failure()->set_reason("DIVERGED");
  job.mutable_failure()->set_message("the energy grows");
  job.mutable_failure()->set_step(10);
  job.mutable_failure()->set_time(0.5);
  job.mutable_failure()->set_particle(7);
  job.mutable_failure()->set_remedy("take smaller steps");
  job.mutable_result()->set_name("result.vtkhdf");
  job.mutable_result()->set_size(2048);
  EXPECT_EQ(describe_job(job),
            "job        j\n"
            "scene      beam\n"
            "state      failed\n"
            "progress   25 %, time 0.5 of 2, step 10 of 40\n"
            "failure    DIVERGED: the energy grows (step 10, time 0.5, particle 7)\n"
            "remedy     take smaller steps\n"
            "result     result.vtkhdf (2.0 KiB, incomplete: the run ended early)\n");
}

TEST(ProgressLine, FitsTheTerminal) {
  v1::Progress progress;
  progress.set_time(0.5);
  progress.set_end_time(1);
  progress.set_step(500);
  progress.set_total_steps(1000);
  progress.set_particle_steps_per_second(2.5e7);
  progress.mutable_remaining()->set_seconds(75);
  const std::string wide = progress_line("beam", progress, 200);
  EXPECT_NE(wide.find(" 50 %"), std::string::npos);
  EXPECT_NE(wide.find("1:15 left"), std::string::npos);
  EXPECT_NE(wide.find("25 M particles/s"), std::string::npos);
  EXPECT_EQ(progress_line("beam", progress, 60).find("particles/s"), std::string::npos);
}

TEST(Gnuplot, TextCannotEndItsQuotes) { EXPECT_EQ(gnuplot_text("it's\n'`x`"), "'it''s ''`x`'"); }

/// A job of one measure of `tip.x` over 4 units of time, with the constant E = 1/2.
v1::Job measured_job() {
  v1::Job job;
  v1::Scene& scene = *job.mutable_scene();
  scene.mutable_analysis()->set_end_time(4);
  v1::Constant& constant = *scene.add_constants();
  constant.set_name("E");
  constant.set_value("1/2");
  v1::Measure& measure = *scene.add_measures();
  measure.set_name("first");
  measure.set_quantity("tip.x");
  return job;
}

TEST(ExactHistories, AreTheFormulasOfDeviations) {
  v1::Job job = measured_job();
  job.mutable_scene()->mutable_measures(0)->mutable_deviation()->set_exact_history(
      "t < 2 ? E*t^2 : max(1, t, pi)");
  const std::vector<ExactHistory> exact = exact_histories(job);
  ASSERT_EQ(exact.size(), 1u);
  EXPECT_EQ(exact[0].column, "tip.x");
  const auto at = [&](double time) {
    const auto point = std::ranges::lower_bound(exact[0].time, time);
    return exact[0].value.at(static_cast<std::size_t>(point - exact[0].time.begin()));
  };
  EXPECT_EQ(at(1), 0.5);
  EXPECT_EQ(at(2), std::numbers::pi);
  EXPECT_EQ(at(4), 4);
}

TEST(ExactHistories, LeaveOutFormulasThatCannotBeRead) {
  v1::Job job = measured_job();
  job.mutable_scene()->mutable_measures(0)->mutable_deviation()->set_exact_history("2 * unknown");
  testing::internal::CaptureStderr();
  EXPECT_TRUE(exact_histories(job).empty());
  EXPECT_NE(testing::internal::GetCapturedStderr().find("\"first\" is left out"), std::string::npos);
}

TEST(ExactHistories, HaveEachValueOfAColumnOnce) {
  v1::Job job = measured_job();
  job.mutable_scene()->mutable_measures(0)->mutable_final();
  *job.mutable_scene()->add_measures() = job.scene().measures(0);
  *job.mutable_scene()->add_measures() = job.scene().measures(0);
  const char* names[] = {"first", "same", "other"};
  const double values[] = {7, 7, 8};
  for (int i = 0; i < 3; ++i) {
    job.mutable_scene()->mutable_measures(i)->set_name(names[i]);
    v1::MeasureValue& value = *job.add_measures();
    value.set_name(names[i]);
    value.set_exact(values[i]);
  }
  const std::vector<ExactHistory> exact = exact_histories(job);
  ASSERT_EQ(exact.size(), 2u);
  EXPECT_EQ(exact[0].measure, "first");
  EXPECT_EQ(exact[1].measure, "other");
  EXPECT_EQ(exact[1].time, (std::vector<double>{0, 4}));
  EXPECT_EQ(exact[1].value, (std::vector<double>{8, 8}));
}

TEST(UnitLabels, NameDerivedUnits) {
  const UnitLabels si("m, s, kg");
  EXPECT_EQ(si.of_column("tip.velocity.y"), "m/s");
  EXPECT_EQ(si.of_column("tip.stress.xx"), "Pa");
  EXPECT_EQ(si.of_column("energies.balance_error"), "");
  EXPECT_EQ(UnitLabels("m, ms, t").of_column("stress.xx"), "GPa");
  EXPECT_EQ(UnitLabels("cm, s, g").of_column("energies.kinetic"), "g cm²/s²");
  EXPECT_EQ(UnitLabels("any consistent units").of_column("tip.velocity.y"), "");
}

TEST(Numbers, AreShortForPeople) {
  EXPECT_EQ(bytes_for_people(1536), "1.5 KiB");
  EXPECT_EQ(count_for_people(999), "999");
  EXPECT_EQ(count_for_people(2.5e7), "25 M");
  EXPECT_EQ(duration_for_people(3725), "1:02:05");
}

TEST(RandomId, IsAVersion4UuidAndNeverTheSame) {
  const std::string id = random_id();
  ASSERT_EQ(id.size(), 36u);
  EXPECT_EQ(id[14], '4');
  EXPECT_NE(std::string("89ab").find(id[19]), std::string::npos);
  EXPECT_NE(random_id(), id);
}

}  // namespace
}  // namespace trajan::client
