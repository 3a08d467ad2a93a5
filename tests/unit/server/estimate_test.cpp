#include "server/estimate.h"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include <cmath>

#include "server/audit.h"
#include "server/check_scene.h"
#include "server/estimate_errors.h"
#include "server/scene_digest.h"
#include "solver/cost/course.h"
#include "solver/cost/measure_rates.h"
#include "solver/cost/rates.h"

namespace trajan {
namespace {

v1::Scene bar(double cell = 0.25) {
  v1::Scene scene;
  const bool parsed = google::protobuf::TextFormat::ParseFromString(R"scene(
    name: "bar"
    domain { dimension: PLANE_STRESS upper { x: 10 y: 1 } }
    materials { name: "elastic" density: 1 linear_elastic { youngs_modulus: 10000 } }
    bodies { name: "bar" material: "elastic" geometry { box { upper { x: 10 y: 1 } } } }
    analysis { end_time: 1 }
    numerics { scheme: "MUSL" shape_functions: "linear" }
    outputs { samples: 10 probes { name: "tip" nearest { x: 10 } fields: DISPLACEMENT } }
    measures { name: "tip" quantity: "tip.displacement.x" extreme {} }
  )scene",
                                                                    &scene);
  EXPECT_TRUE(parsed);
  scene.mutable_domain()->set_cell_size(cell);
  return scene;
}

/// A machine that needs a microsecond for each particle and step, and nothing for all else.
v1::Calibration one_microsecond() {
  Numerics numerics;
  v1::Calibration calibration;
  auto& seconds = *calibration.mutable_seconds();
  auto& bytes = *calibration.mutable_bytes();
  for (const char* of : {"step", "tile"}) seconds[step_rate(Dimension::plane_stress, numerics, of)] = 0;
  seconds[step_rate(Dimension::plane_stress, numerics, "particle")] = 1e-6;
  seconds[law_rate(Dimension::plane_stress, false, "linear_elastic")] = 0;
  seconds[sample_rate(Dimension::plane_stress, false, "linear_elastic")] = 0;
  seconds[memory_rate()] = seconds[formula_rate()] = 0;
  for (const char* of : {"run", "row", "particle", "snapshot", "snapshot_byte"})
    seconds[recording_rate(of)] = seconds[processing_rate(of)] = bytes[recording_rate(of)] = 0;
  bytes[recording_rate("running")] = 0;
  return calibration;
}

v1::Prediction finished(const v1::Scene& scene, double expected, double took, const std::string& job = "1") {
  v1::Prediction prediction;
  prediction.set_job_id(job);
  *prediction.mutable_settings() = settings_of(scene);
  v1::Figure& wall = *prediction.mutable_estimate()->mutable_wall_seconds();
  wall.set_value(expected);
  wall.set_low(expected / 1.5);
  wall.set_high(expected * 1.5);
  wall.set_source(v1::Figure::MODEL);
  prediction.mutable_estimate()->set_model_wall_seconds(expected);
  prediction.mutable_cost()->set_wall_seconds(took);
  prediction.mutable_cost()->set_core_seconds(took);
  prediction.mutable_cost()->set_threads(1);
  prediction.set_solver_version(TRAJAN_VERSION);
  return prediction;
}

v1::Estimate estimate_of(const v1::Scene& scene, const Evidence& evidence) {
  v1::Estimate made = estimate(scene, require_valid(scene), evidence);
  name_neighbours(scene, evidence, made);
  return made;
}

TEST(Estimate, SaysOfEveryFigureWhereItComesFrom) {
  Evidence evidence;
  evidence.calibration = one_microsecond();
  const v1::Estimate estimate = estimate_of(bar(), evidence);
  EXPECT_EQ(estimate.missing(), "");
  for (const auto* figure :
       {&estimate.steps(), &estimate.time_step(), &estimate.memory_bytes(), &estimate.core_seconds(),
        &estimate.wall_seconds(), &estimate.result_bytes(), &estimate.queue_seconds()}) {
    EXPECT_EQ(figure->source(), v1::Figure::MODEL) << figure->ShortDebugString();
    EXPECT_LE(figure->low(), figure->value());
    EXPECT_GE(figure->high(), figure->value());
    EXPECT_NE(figure->basis(), "");
  }
  for (const v1::Neighbour& neighbour : estimate.neighbours()) EXPECT_EQ(neighbour.source(), v1::Figure::MODEL);
}

TEST(Estimate, IsCountedWorkTimesRates) {
  Evidence evidence;
  evidence.calibration = one_microsecond();
  const v1::Estimate estimate = estimate_of(bar(), evidence);
  // 40 x 4 cells with four particles each; steps of half of 0.25 / (sqrt(2) 100), waves having the speed 100, so
  // that 0.1 takes 114 of them.
  EXPECT_EQ(estimate.steps().value(), 1140);
  EXPECT_NEAR(estimate.core_seconds().value(), 1140 * 640 * 1e-6, 1e-12);
}

TEST(Estimate, HasAFileOfHistoriesAloneWhereThereAreNoSnapshots) {
  v1::Scene coarse = bar();
  coarse.mutable_outputs()->set_snapshots(0);
  v1::Scene fine = coarse;
  fine.mutable_domain()->set_cell_size(coarse.domain().cell_size() / 2);
  EXPECT_EQ(estimate_of(coarse, {}).result_bytes().value(), estimate_of(fine, {}).result_bytes().value());
}

TEST(Estimate, WithoutCalibrationSaysWhatIsMissing) {
  const v1::Estimate estimate = estimate_of(bar(), {});
  EXPECT_FALSE(estimate.has_wall_seconds());
  EXPECT_NE(estimate.missing(), "");
  EXPECT_EQ(estimate.steps().value(), 1140);
}

TEST(Estimate, TakesWhatAFinishedRunOfTheFamilyTookInProportion) {
  Evidence evidence;
  evidence.calibration = one_microsecond();
  const double model = estimate_of(bar(0.25), evidence).wall_seconds().value();
  const double coarse = estimate_of(bar(0.5), evidence).wall_seconds().value();
  evidence.family = {finished(bar(0.5), coarse, 2 * coarse, "12")};
  const v1::Figure wall = estimate_of(bar(0.25), evidence).wall_seconds();
  EXPECT_EQ(wall.source(), v1::Figure::HISTORY);
  EXPECT_THAT(wall.basis(), testing::HasSubstr("job 12"));
  EXPECT_NEAR(wall.value(), 2 * model, 1e-12);
}

TEST(Estimate, PrefersATrialOfTheSceneItself) {
  Evidence evidence;
  evidence.family = {finished(bar(), 1, 1)};
  evidence.trial.emplace();
  evidence.trial->set_steps(1140);
  evidence.trial->mutable_cost()->set_wall_seconds(12);
  const v1::Figure wall = estimate_of(bar(), evidence).wall_seconds();
  EXPECT_EQ(wall.source(), v1::Figure::PROBE);
  EXPECT_NEAR(wall.value(), 12, 1e-12);
}

TEST(Course, TellsWhatWasSpentAtAShareOfTheTime) {
  const Course course{{}, {0.5, 10, 1}, {1, 30, 4}};
  EXPECT_DOUBLE_EQ(spent(course, 0.25).steps, 5. / 30);
  EXPECT_DOUBLE_EQ(spent(course, 0.25).seconds, 0.5 / 4);
  EXPECT_DOUBLE_EQ(spent(course, 0.75).steps, 20. / 30);
  EXPECT_DOUBLE_EQ(spent(course, 0.75).seconds, 2.5 / 4);
  EXPECT_DOUBLE_EQ(spent(course, 1).seconds, 1);
}

TEST(Estimate, ScalesErrorsOfTheFamilyByTheOrderThatItShowed) {
  Evidence evidence;
  evidence.calibration = one_microsecond();
  for (const auto& [cell, error] : {std::pair{1.0, 0.08}, {0.5, 0.02}}) {
    v1::Finding& finding = evidence.findings.emplace_back();
    finding.set_measure("tip");
    finding.set_error(error);
    *finding.mutable_settings() = settings_of(bar(cell));
  }
  const v1::Estimate estimate = estimate_of(bar(0.25), evidence);
  ASSERT_EQ(estimate.errors_size(), 1);
  EXPECT_NEAR(estimate.errors(0).error().value(), 0.005, 1e-12);  // of order 2
  EXPECT_EQ(estimate.errors(0).error().source(), v1::Figure::HISTORY);
  ASSERT_GE(estimate.neighbours_size(), 2);
  // Cells of half the size: a quarter of the error; four times as many particles, twice as many steps but for
  // rounding to whole ones.
  EXPECT_NEAR(estimate.neighbours(0).error_ratio(), 0.25, 1e-12);
  EXPECT_NEAR(estimate.neighbours(0).cost_ratio(), 8, 0.1);
}

TEST(Audit, CountsHowOftenIntervalsHeld) {
  std::vector<v1::Prediction> jobs;
  for (const double took : {1.0, 1.2, 1.4, 2.0}) jobs.push_back(finished(bar(), 1, took));
  jobs[1].mutable_estimate()->mutable_wall_seconds()->set_source(v1::Figure::HISTORY);
  std::map<v1::Figure::Source, v1::Coverage> wall;
  for (const v1::Coverage& coverage : coverages(jobs))
    if (coverage.figure() == "wall_seconds") wall[coverage.source()] = coverage;
  // Intervals go to 1.5; 1 is within a quarter of 1 and 1.2.
  EXPECT_EQ(wall.at(v1::Figure::SOURCE_UNSPECIFIED).jobs(), 4);
  EXPECT_EQ(wall.at(v1::Figure::SOURCE_UNSPECIFIED).within(), 3);
  EXPECT_EQ(wall.at(v1::Figure::SOURCE_UNSPECIFIED).within_quarter(), 2);
  EXPECT_EQ(wall.at(v1::Figure::MODEL).jobs(), 3);
  EXPECT_EQ(wall.at(v1::Figure::MODEL).within(), 2);
  EXPECT_EQ(wall.at(v1::Figure::HISTORY).within(), 1);
}

TEST(Audit, KnowsTheFactorThatNineOfTenKept) {
  std::vector<v1::Prediction> jobs;
  for (int i = 0; i < 18; ++i) jobs.push_back(finished(bar(), 1, 1 + 0.1 * i));
  EXPECT_FALSE(usual_factor(jobs, v1::Figure::MODEL)) << "too few";
  jobs.push_back(finished(bar(), 1, 2.8));
  // The next one is equally likely to come on each of 20 ranks: with 0.9 on one of the first 18.
  EXPECT_NEAR(usual_factor(jobs, v1::Figure::MODEL).value(), 2.7, 1e-12);
  EXPECT_FALSE(usual_factor(jobs, v1::Figure::HISTORY));
}

}  // namespace
}  // namespace trajan
