#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "client/gnuplot.h"
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

TEST(Gnuplot, ExpressionsDivideWholeNumbersAsNumbers) {
  v1::Scene scene;
  v1::Constant& constant = *scene.add_constants();
  constant.set_name("E");
  constant.set_value("1/2");
  EXPECT_EQ(gnuplot_expression("E*t^2 + 1/4 - 1e-3", scene), "constant_E*x**2.0 + 1.0/4.0 - 1e-3");
  EXPECT_EQ(gnuplot_constants(scene), "constant_E = 1.0/2.0\n");
}

TEST(Gnuplot, ExpressionsCannotRunCommands) {
  EXPECT_EQ(gnuplot_expression("system(1)", v1::Scene()), std::nullopt);
  EXPECT_EQ(gnuplot_expression("1; print 2", v1::Scene()), std::nullopt);
  EXPECT_EQ(gnuplot_expression("`date`", v1::Scene()), std::nullopt);
}

TEST(UnitLabels, NameDerivedUnits) {
  const UnitLabels si("m, s, kg");
  EXPECT_EQ(si.of_column("tip.velocity.y"), "m/s");
  EXPECT_EQ(si.of_column("tip.stress.xx"), "Pa");
  EXPECT_EQ(si.of_column("energies.balance_error"), "");
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
