#include "server/study_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace trajan {
namespace {

v1::Run& add_run(v1::Study& study, const std::vector<std::string>& settings, double value, double cost) {
  v1::Run& run = *study.add_runs();
  run.set_state(v1::SUCCEEDED);
  for (const std::string& setting : settings) run.add_settings(setting);
  v1::MeasureValue& measure = *run.add_measures();
  measure.set_name("tip");
  measure.set_value(value);
  run.mutable_cost()->set_core_seconds(cost);
  return run;
}

v1::Study ladder() {
  v1::Study study;
  study.mutable_job()->mutable_study()->set_kind("ladder");
  study.add_dials(cell_size_dial);
  for (const double size : {0.4, 0.2, 0.1}) add_run(study, {std::to_string(size)}, 3 + size * size, 1);
  return study;
}

TEST(StudyTable, ExtrapolatesTheMeasuresOfALadder) {
  v1::Study study = ladder();
  derive(study, {});
  ASSERT_EQ(study.convergences_size(), 1);
  const v1::Convergence& found = study.convergences(0);
  EXPECT_EQ(found.behaviour(), v1::Convergence::MONOTONE);
  EXPECT_NEAR(found.order(), 2, 1e-9) << "12 of 16 digits are left after the differences";
  EXPECT_NEAR(found.extrapolated(), 3, 1e-9);
  EXPECT_GE(found.band(), 0.01);
}

TEST(StudyTable, ClaimsNothingOfChecks) {
  v1::Scene scene;
  v1::Measure& measure = *scene.add_measures();
  measure.set_name("tip");
  measure.set_quantity("energies.balance_error");
  v1::Study energy = ladder();
  derive(energy, scene);
  EXPECT_FALSE(energy.convergences(0).has_band());
  EXPECT_NE(energy.convergences(0).no_claim(), "");
  measure.set_quantity("tip.velocity.x");
  v1::Study rest = ladder();
  rest.mutable_runs(2)->mutable_measures(0)->set_exact(0);
  derive(rest, scene);
  EXPECT_FALSE(rest.convergences(0).has_band()) << "what should be at rest";
  measure.mutable_deviation();
  v1::Study deviation = ladder();
  deviation.mutable_runs(2)->mutable_measures(0)->set_exact(0);
  derive(deviation, scene);
  EXPECT_TRUE(deviation.convergences(0).has_band()) << "of a curve that is not rest";
}

TEST(StudyTable, SaysNothingOfALadderThatIsNotWhole) {
  v1::Study study = ladder();
  study.mutable_runs(1)->set_state(v1::FAILED);
  derive(study, {});
  EXPECT_EQ(study.convergences_size(), 0);
}

v1::Study tradeoff(const std::string& reference_source) {
  v1::Study study;
  study.mutable_job()->mutable_study()->set_kind("tradeoff");
  study.mutable_trade()->set_measure("tip");
  study.mutable_trade()->set_reference_source(reference_source);
  study.add_dials("method");
  study.add_dials(cell_size_dial);
  return study;
}

TEST(StudyTable, MarksTheParetoSetOfATradeoffAndItsCheapestRuns) {
  v1::Study study = tradeoff("exact");
  add_run(study, {"slow", "0.2"}, 1.05, 10).mutable_measures(0)->set_error(0.05);
  add_run(study, {"fast", "0.2"}, 0.98, 1).mutable_measures(0)->set_error(-0.02);
  add_run(study, {"fast", "0.1"}, 0.996, 4).mutable_measures(0)->set_error(-0.004);
  derive(study, {});
  EXPECT_FALSE(study.runs(0).pareto());
  EXPECT_TRUE(study.runs(1).pareto());
  EXPECT_TRUE(study.runs(2).pareto());
  EXPECT_EQ(study.runs(1).error(), 0.02) << "a magnitude";
  ASSERT_EQ(study.trade().cheapest_size(), 5);
  EXPECT_EQ(study.trade().cheapest(0).run(), 1) << "10 %";
  EXPECT_EQ(study.trade().cheapest(2).run(), 2) << "1 %";
  EXPECT_FALSE(study.trade().cheapest(4).has_run()) << "0.1 %";
}

TEST(StudyTable, MeasuresErrorsAgainstTheBestExtrapolationIfThereIsNoExactValue) {
  v1::Study study = tradeoff("extrapolated");
  for (const double size : {0.4, 0.2, 0.1})
    add_run(study, {"second order", std::to_string(size)}, 3 + size * size, 1);
  for (const double size : {0.4, 0.2, 0.1}) add_run(study, {"first order", std::to_string(size)}, 3 - size, 2);
  derive(study, {});
  EXPECT_NEAR(study.trade().reference(), 3, 1e-9);
  EXPECT_GT(study.trade().reference_band(), 0);
  EXPECT_NEAR(study.runs(5).error(), 0.1 / 3, 1e-9);
}

TEST(StudyTable, LeavesOutWhatHasFailed) {
  v1::Study study = tradeoff("exact");
  v1::Run& failed = add_run(study, {"slow", "0.2"}, 1, 10);
  failed.set_state(v1::FAILED);
  failed.clear_measures();
  add_run(study, {"fast", "0.2"}, 0.98, 1).mutable_measures(0)->set_error(-0.02);
  derive(study, {});
  EXPECT_FALSE(study.runs(0).has_error());
  EXPECT_TRUE(study.runs(1).pareto());
}

}  // namespace
}  // namespace trajan
