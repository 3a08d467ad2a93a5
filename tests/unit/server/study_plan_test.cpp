#include "server/study_plan.h"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <set>

#include "server/errors.h"

namespace trajan::study_plan_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

v1::SubmitStudyRequest bar() {
  v1::SubmitStudyRequest request;
  google::protobuf::TextFormat::ParseFromString(
      R"(name: "bar" constants { name: "cell" value: "0.5" }
         domain { dimension: BAR lower { x: 0 } upper { x: 12 } cell_size: 0.5 }
         materials { name: "steel" density: 1 linear_elastic { youngs_modulus: 100 poissons_ratio: 0 } }
         bodies { name: "bar" material: "steel" geometry { box { lower { x: 0 } upper { x: 10 } } } }
         analysis { end_time: 1 } outputs { probes { name: "tip" nearest { x: 10 } fields: DISPLACEMENT } }
         measures { name: "tip" quantity: "tip.displacement.x" final {} exact: "0" })",
      request.mutable_scene());
  return request;
}

void add_dial(v1::SubmitStudyRequest& request, const std::string& path, const std::vector<std::string>& values) {
  v1::Dial& dial = *request.mutable_sweep()->add_dials();
  dial.set_name(path);
  for (const std::string& value : values) {
    v1::Setting& setting = *dial.add_settings();
    setting.set_name(value);
    setting.add_changes(std::string(path).append("=").append(value));
  }
}

v1::ErrorDetails refusal(const v1::SubmitStudyRequest& request) {
  try {
    plan_study(request);
  } catch (const ServiceError& error) {
    EXPECT_EQ(error.code(), grpc::StatusCode::INVALID_ARGUMENT);
    return error.details();
  }
  ADD_FAILURE() << "it was not refused";
  return {};
}

TEST(StudyPlan, HasAllCombinationsAndTheLastDialVariesFastest) {
  v1::SubmitStudyRequest request = bar();
  add_dial(request, "domain.cell_size", {"1", "0.5"});
  add_dial(request, "numerics.scheme", {"MUSL", "USL", "TLMPM"});
  const store::StudyPlan plan = plan_study(request);
  ASSERT_EQ(plan.runs.size(), 6U);
  EXPECT_THAT(plan.study.dials(), ElementsAre("domain.cell_size", "numerics.scheme"));
  EXPECT_THAT(plan.runs[1].run.settings(), ElementsAre("1", "USL"));
  EXPECT_EQ(plan.runs[1].scene.domain().cell_size(), 1);
  EXPECT_EQ(plan.runs[1].scene.numerics().scheme(), "USL");
  EXPECT_THAT(plan.runs[5].run.settings(), ElementsAre("0.5", "TLMPM"));
}

TEST(StudyPlan, ReportsTheViolationsOfAllRunsWithTheRunsThatHaveThem) {
  v1::SubmitStudyRequest request = bar();
  add_dial(request, "domain.cell_size", {"1", "-1"});
  add_dial(request, "numerics.scheme", {"MUSL", "MISL"});
  const v1::ErrorDetails details = refusal(request);
  std::map<std::string, std::string> runs;
  for (const v1::Violation& violation : details.violations()) runs[violation.path()] = violation.run();
  EXPECT_EQ(runs["domain.cell_size"],
            "domain.cell_size=-1, numerics.scheme=MUSL; domain.cell_size=-1, numerics.scheme=MISL");
  EXPECT_THAT(runs["numerics.scheme"], HasSubstr("domain.cell_size=1, numerics.scheme=MISL"));
}

TEST(StudyPlan, ReportsWhatIsWrongWithTheSceneItselfOnce) {
  v1::SubmitStudyRequest request = bar();
  request.mutable_scene()->mutable_materials(0)->set_density(-1);
  add_dial(request, "domain.cell_size", {"1", "0.5"});
  const v1::ErrorDetails details = refusal(request);
  ASSERT_EQ(details.violations_size(), 1);
  EXPECT_EQ(details.violations(0).path(), "materials[0].density");
  EXPECT_EQ(details.violations(0).run(), "");
}

TEST(StudyPlan, NamesFieldsThatDoNotExist) {
  v1::SubmitStudyRequest request = bar();
  add_dial(request, "domain.cell_sise", {"1"});
  const v1::ErrorDetails details = refusal(request);
  ASSERT_EQ(details.violations_size(), 1);
  EXPECT_EQ(details.violations(0).path(), "domain.cell_sise");
  EXPECT_THAT(details.violations(0).remedy(), HasSubstr("cell_size"));
}

TEST(StudyPlan, RefusesTooManyRunsAndDialsWithoutSense) {
  v1::SubmitStudyRequest many = bar();
  std::vector<std::string> values;
  for (int i = 1; i <= 40; ++i) values.push_back(std::to_string(i));
  add_dial(many, "domain.cell_size", values);
  add_dial(many, "analysis.end_time", values);
  EXPECT_EQ(refusal(many).reason(), "TOO_MANY_RUNS");
  v1::SubmitStudyRequest twice = bar();
  add_dial(twice, "domain.cell_size", {"1", "1"});
  EXPECT_EQ(refusal(twice).reason(), "DIALS");
  v1::SubmitStudyRequest none = bar();
  EXPECT_EQ(refusal(none).reason(), "KIND");
  none.mutable_sweep();
  EXPECT_EQ(refusal(none).reason(), "DIALS");
}

TEST(StudyPlan, ChangesWithTheCellSizeWhatIsInProportionToIt) {
  v1::SubmitStudyRequest request = bar();
  request.mutable_scene()->mutable_numerics()->set_time_step(0.01);
  request.mutable_ladder()->set_levels(4);
  const store::StudyPlan plan = plan_study(request);
  ASSERT_EQ(plan.runs.size(), 4U);
  std::vector<double> sizes;
  for (const store::PlannedRun& planned : plan.runs) {
    sizes.push_back(planned.scene.domain().cell_size());
    EXPECT_EQ(std::stod(planned.scene.constants(0).value()), sizes.back());
    EXPECT_DOUBLE_EQ(planned.scene.numerics().time_step(), 0.02 * sizes.back());
    EXPECT_EQ(std::stod(planned.run.settings(0)), sizes.back());
  }
  EXPECT_THAT(sizes, ElementsAre(4, 2, 1, 0.5));
}

TEST(StudyPlan, RefusesLaddersOutOfRange) {
  for (const auto change :
       {+[](v1::Ladder& ladder) { ladder.set_levels(2); }, +[](v1::Ladder& ladder) { ladder.set_ratio(1); },
        +[](v1::Ladder& ladder) { ladder.set_finest(0); }}) {
    v1::SubmitStudyRequest request = bar();
    change(*request.mutable_ladder());
    EXPECT_EQ(refusal(request).reason(), "LADDER");
  }
}

TEST(StudyPlan, LeavesOutCombinationsThatAreNotValidAndCountsThem) {
  v1::SubmitStudyRequest request = bar();
  v1::Dial& shapes = *request.mutable_tradeoff()->add_dials();
  shapes.set_name("shapes");
  for (const std::string shape : {"linear", "bernstein"}) {
    v1::Setting& setting = *shapes.add_settings();
    setting.set_name(shape);
    setting.add_changes("numerics.shape_functions=" + shape);
  }
  const store::StudyPlan plan = plan_study(request);
  ASSERT_EQ(plan.runs.size(), 1U) << "MUSL has no Bernstein functions";
  EXPECT_THAT(plan.runs[0].run.settings(), ElementsAre("linear"));
  ASSERT_EQ(plan.study.trade().skipped_size(), 1);
  EXPECT_EQ(plan.study.trade().skipped(0).combinations(), 1);
  EXPECT_EQ(plan.study.trade().reference_source(), "exact");
  request.mutable_tradeoff()->set_measure("tap");
  EXPECT_EQ(refusal(request).reason(), "MEASURE");
}

TEST(StudyPlan, TriesMethodsOnThreeGridsIfATradeoffNamesNoDials) {
  v1::SubmitStudyRequest request = bar();
  request.mutable_tradeoff();
  const store::StudyPlan plan = plan_study(request);
  EXPECT_THAT(plan.study.dials(), ElementsAre("method", "domain.cell_size"));
  EXPECT_GE(plan.runs.size(), 15U);
  std::set<std::string> kinds;
  for (const store::PlannedRun& planned : plan.runs)
    kinds.insert(planned.scene.analysis().has_implicit_dynamics() ? "implicit" : "explicit");
  EXPECT_EQ(kinds.size(), 2U);
  EXPECT_EQ(plan.runs[2].scene.domain().cell_size(), 0.5) << "no finer than an exact value that depends on it";
  request.mutable_scene()->clear_constants();
  EXPECT_EQ(plan_study(request).runs[2].scene.domain().cell_size(), 0.25);
}

}  // namespace
}  // namespace trajan::study_plan_test
