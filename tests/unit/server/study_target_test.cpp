#include "server/study_target.h"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "server/errors.h"
#include "server/fidelity.h"
#include "server/scene_digest.h"

namespace trajan::study_target_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

v1::SubmitJobRequest bar(double tolerance = 0.005) {
  v1::SubmitJobRequest request;
  google::protobuf::TextFormat::ParseFromString(
      R"(name: "bar" constants { name: "cell" value: "0.5" }
         domain { dimension: BAR lower { x: 0 } upper { x: 12 } cell_size: 0.5 }
         materials { name: "steel" density: 1 linear_elastic { youngs_modulus: 100 poissons_ratio: 0 } }
         bodies { name: "bar" material: "steel" geometry { box { lower { x: 0 } upper { x: 10 } } } }
         boundaries { name: "wall" nodes { box { lower { x: 0 } upper { x: 0 } } } fixed {} }
         loads { name: "weight" body_force { acceleration { x: 1 } } }
         analysis { end_time: 1 quasi_static {} }
         outputs { probes { name: "tip" nearest { x: 10 } fields: DISPLACEMENT } }
         measures { name: "tip" quantity: "tip.displacement.x" final {} }
         measures { name: "balance" quantity: "energies.balance_error" final {} exact: "0" })",
      request.mutable_scene());
  v1::Target& target = *request.mutable_fidelity()->mutable_target();
  target.set_measure("tip");
  target.set_relative(tolerance);
  return request;
}

/// What a run would answer by a method with cells of a size.
using Answers = std::function<double(const std::string& method, double cell_size)>;

struct End {
  v1::Study study;
  TargetStep step;
};

/// Leads a target to its end; runs cost the third power of their cells.
End lead(const v1::SubmitJobRequest& request, const Answers& answers,
         const std::vector<v1::Finding>& findings = {}) {
  End end{plan_target(request, findings).study, {}};
  for (int runs = 0; runs < 40; ++runs) {
    end.step = next_step(request.scene(), end.study);
    if (!end.step.run) return end;
    v1::Run& run = *end.study.add_runs();
    run = end.step.run->run;
    const double size = end.step.run->scene.domain().cell_size();
    EXPECT_EQ(std::stod(end.step.run->scene.constants(0).value()), size);
    run.set_state(v1::SUCCEEDED);
    run.mutable_cost()->set_core_seconds(1 / (size * size * size));
    v1::MeasureValue& measure = *run.add_measures();
    measure.set_name("tip");
    measure.set_value(answers(run.settings(0), size));
  }
  ADD_FAILURE() << "it does not end";
  return end;
}

/// Of the second order, by quadratic functions with a quarter of the error.
double second_order(const std::string& method, double size) {
  return 1 + (method.ends_with("quadratic") ? 0.01 : 0.04) * size * size;
}

TEST(StudyTarget, ClimbsUntilTheBandIsWithinTheTolerance) {
  for (const double tolerance : {0.1, 0.01, 0.001}) {
    const End end = lead(bar(tolerance), second_order);
    ASSERT_TRUE(end.step.answer && end.step.answer->reached()) << end.step.message;
    EXPECT_LE(end.step.answer->band(), tolerance * end.step.answer->value());
    EXPECT_LE(std::abs(end.step.answer->value() - 1), end.step.answer->band()) << "the exact value is 1";
    double sum = 0;
    for (const v1::Run& run : end.study.runs()) sum += run.cost().core_seconds();
    EXPECT_DOUBLE_EQ(end.step.answer->core_seconds(), sum);
  }
}

TEST(StudyTarget, TakesCellsThatTheBodyIsAWholeNumberOf) {
  const End end = lead(bar(1e-4), second_order);
  for (const v1::Run& run : end.study.runs()) {
    const double cells = 10 / std::stod(run.settings(1));
    EXPECT_NEAR(cells, std::round(cells), 1e-9) << "of a bar of 10";
  }
}

TEST(StudyTarget, GoesOnWithTheMethodThatWillBeCheaper) {
  const End end = lead(bar(0.002), second_order);
  ASSERT_TRUE(end.step.answer && end.step.answer->reached());
  const v1::Run& answer = end.study.runs(end.step.answer->run());
  EXPECT_THAT(answer.settings(0), HasSubstr("quadratic"));
  int others = 0;
  for (const v1::Run& run : end.study.runs()) others += run.settings(0) != answer.settings(0);
  EXPECT_EQ(others, 4) << "two coarse grids tell enough of each of the two others";
}

// By quadratic functions the first grids agree on 2: something that finer ones will change.
TEST(StudyTarget, BelievesNoTwoGridsThatAnotherMethodContradicts) {
  const End end = lead(bar(0.005), [](const std::string& method, double size) {
    if (method.ends_with("quadratic")) return size < 0.9 ? 1 + 0.01 * size : 2 + 0.001 * size;
    return second_order(method, size);
  });
  ASSERT_TRUE(end.step.answer && end.step.answer->reached()) << end.step.message;
  EXPECT_NEAR(end.step.answer->value(), 1, 0.005);
}

TEST(StudyTarget, SaysWhatBandItReachedWithinTheBudget) {
  v1::SubmitJobRequest request = bar(1e-6);
  request.mutable_fidelity()->mutable_target()->set_budget_core_seconds(20);
  const End end = lead(request, second_order);
  ASSERT_TRUE(end.step.answer);
  EXPECT_FALSE(end.step.answer->reached());
  EXPECT_GT(end.step.answer->band(), 1e-6);
  EXPECT_LE(end.step.answer->core_seconds(), 20);
  EXPECT_THAT(end.step.answer->end(), HasSubstr("the budget is 20"));
  EXPECT_THAT(end.step.message, HasSubstr("tip is 1."));
}

TEST(StudyTarget, GoesRoundRunsThatFail) {
  v1::Study study = plan_target(bar(), {}).study;
  TargetStep step = next_step(bar().scene(), study);
  const double coarsest = step.run->scene.domain().cell_size();
  *study.add_runs() = step.run->run;
  study.mutable_runs(0)->set_state(v1::FAILED);
  step = next_step(bar().scene(), study);
  ASSERT_TRUE(step.run);
  EXPECT_DOUBLE_EQ(step.run->scene.domain().cell_size(), coarsest / 2);
  EXPECT_FALSE(step.answer);
}

TEST(StudyTarget, BeginsWithTheMethodThatIsKnownToReachTheTolerance) {
  const v1::Study fresh = plan_target(bar(), {}).study;
  EXPECT_THAT(fresh.methods(),
              ElementsAre("implicit, TLMPM linear", "implicit, TLMPM quadratic", "implicit, as the scene says"));
  v1::Finding finding;
  finding.set_measure("tip");
  finding.set_error(0.004);
  v1::Study study = fresh;
  study.mutable_methods()->DeleteSubrange(0, 1);
  *finding.mutable_settings() = settings_of(next_step(bar().scene(), study).run->scene);
  EXPECT_EQ(plan_target(bar(), {finding}).study.methods(0), "implicit, TLMPM quadratic");
  finding.set_error(0.006);
  EXPECT_EQ(plan_target(bar(), {finding}).study.methods(0), fresh.methods(0));
}

TEST(StudyTarget, RefusesWhatHasNoSense) {
  const auto refusal = [](const v1::SubmitJobRequest& request) {
    try {
      plan_target(request, {});
    } catch (const ServiceError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  v1::SubmitJobRequest unknown = bar();
  unknown.mutable_fidelity()->mutable_target()->set_measure("tap");
  EXPECT_THAT(refusal(unknown), HasSubstr("it has: tip, balance"));
  v1::SubmitJobRequest check = bar();
  check.mutable_fidelity()->mutable_target()->set_measure("balance");
  EXPECT_THAT(refusal(check), HasSubstr("check"));
  EXPECT_THAT(refusal(bar(0)), HasSubstr("tolerance > 0"));
}

TEST(Fidelity, ChangesTheCellsAndWhatGoesWithThem) {
  for (const auto& [preset, size] :
       {std::pair(v1::PREVIEW, 1.0), std::pair(v1::STANDARD, 0.5), std::pair(v1::REFERENCE, 0.25)}) {
    v1::SubmitJobRequest request = bar();
    request.mutable_fidelity()->set_preset(preset);
    resolve_fidelity(request.fidelity(), *request.mutable_scene());
    EXPECT_EQ(request.scene().domain().cell_size(), size);
    EXPECT_EQ(std::stod(request.scene().constants(0).value()), size);
  }
}

TEST(Fidelity, RepeatsARunByTheSettingsThatItTells) {
  v1::SubmitJobRequest first = bar();
  *first.mutable_fidelity()->mutable_target() = bar().fidelity().target();
  const v1::Scene computed = next_step(first.scene(), plan_target(first, {}).study).run->scene;
  v1::SubmitJobRequest again = bar();
  *again.mutable_fidelity()->mutable_settings() = settings_of(computed);
  resolve_fidelity(again.fidelity(), *again.mutable_scene());
  EXPECT_EQ(settings_of(again.scene()).SerializeAsString(), settings_of(computed).SerializeAsString());
  EXPECT_EQ(again.scene().constants(0).value(), computed.constants(0).value());
}

}  // namespace
}  // namespace trajan::study_target_test
