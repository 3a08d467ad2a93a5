#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <set>

#include "tests/service/service.h"

namespace trajan::test {
namespace {

/// A hanging rod, whose end sinks by g L^2 / 2 E at small strain.
v1::SubmitJobRequest rod(double tolerance) {
  v1::SubmitJobRequest request;
  google::protobuf::TextFormat::ParseFromString(
      R"(name: "rod"
         domain { dimension: BAR lower { x: 0 } upper { x: 1.5 } cell_size: 0.0625 }
         materials { name: "soft" density: 1 linear_elastic { youngs_modulus: 1e6 poissons_ratio: 0 } }
         bodies { name: "rod" material: "soft" geometry { box { lower { x: 0 } upper { x: 1 } } } }
         boundaries { name: "ceiling" nodes { box { lower { x: 0 } upper { x: 0 } } } fixed {} }
         loads { name: "gravity" body_force { acceleration { x: 0.01 } } }
         analysis { end_time: 1 quasi_static { load_steps: 1 } }
         outputs { samples: 1 snapshots: 1 probes { name: "end" nearest { x: 1 } fields: DISPLACEMENT } }
         measures { name: "end" quantity: "end.displacement.x" final {} })",
      request.mutable_scene());
  v1::Target& target = *request.mutable_fidelity()->mutable_target();
  target.set_measure("end");
  target.set_relative(tolerance);
  return request;
}

/// The same in a plane, where half the cell size costs some five times as much: no ladder ends before a
/// core-second.
v1::SubmitJobRequest plane_rod(double tolerance) {
  v1::SubmitJobRequest request = rod(tolerance);
  v1::Scene& scene = *request.mutable_scene();
  scene.mutable_domain()->set_dimension(v1::Domain::PLANE_STRESS);
  for (v1::Vector* corner : {scene.mutable_domain()->mutable_upper(),
                             scene.mutable_bodies(0)->mutable_geometry()->mutable_box()->mutable_upper(),
                             scene.mutable_boundaries(0)->mutable_nodes()->mutable_box()->mutable_upper()})
    corner->set_y(0.25);
  for (v1::Vector* corner : {scene.mutable_domain()->mutable_lower(),
                             scene.mutable_bodies(0)->mutable_geometry()->mutable_box()->mutable_lower(),
                             scene.mutable_boundaries(0)->mutable_nodes()->mutable_box()->mutable_lower()})
    corner->set_y(0);
  scene.mutable_outputs()->mutable_probes(0)->mutable_nearest()->set_y(0.125);
  return request;
}

#ifdef TRAJAN_SANITIZED
constexpr bool computing_is_slow = true;
#else
constexpr bool computing_is_slow = false;
#endif

constexpr double exact = 0.01 / 2 / 1e6;

std::string submit(Service& service, const v1::SubmitJobRequest& request) {
  grpc::ClientContext context;
  v1::Job job;
  const grpc::Status status = service.jobs().SubmitJob(&context, request, &job);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return job.job_id();
}

TEST(Targets, end_with_the_answer_and_the_files_of_the_run_that_is_within_the_tolerance) {
  Service service;
  const std::string job = submit(service, rod(0.001));
  const v1::Job ended = service.wait(job);
  ASSERT_EQ(ended.state(), v1::SUCCEEDED) << ended.ShortDebugString();
  const v1::Study study = service.study(job);
  EXPECT_TRUE(study.answer().reached());
  EXPECT_LE(study.answer().band(), 0.001 * study.answer().value());
  EXPECT_LE(std::abs(study.answer().value() - exact), study.answer().band());
  const v1::Run& run = study.runs(study.answer().run());
  EXPECT_EQ(ended.measures(0).value(), study.answer().value());
  EXPECT_EQ(ended.answered_by(), run.job_id());
  EXPECT_EQ(ended.settings().SerializeAsString(), service.get(run.job_id()).settings().SerializeAsString());
  EXPECT_EQ(service.history(job, false), service.history(run.job_id(), false));
}

TEST(Targets, fail_with_the_band_that_the_budget_allowed) {
  Service service;
  v1::SubmitJobRequest request = plane_rod(1e-9);
  // A band needs two runs, which must not be too dear where machines are slow.
  request.mutable_fidelity()->mutable_target()->set_budget_core_seconds(computing_is_slow ? 6 : 1);
  const v1::Job ended = service.wait(submit(service, request));
  EXPECT_EQ(ended.state(), v1::FAILED);
  EXPECT_EQ(ended.failure().reason(), "TOLERANCE_NOT_REACHED");
  EXPECT_THAT(ended.failure().message(), testing::HasSubstr("+-"));
  EXPECT_THAT(ended.failure().message(), testing::HasSubstr("and the budget is"));
  EXPECT_EQ(ended.measures_size(), 0) << "no number that is not within the tolerance";
}

TEST(Targets, are_cancelled_between_runs_too) {
  Service service;
  const std::string job = submit(service, rod(1e-9));
  v1::CancelJobRequest request;
  request.set_job_id(job);
  grpc::ClientContext context;
  v1::Job answer;
  ASSERT_TRUE(service.jobs().CancelJob(&context, request, &answer).ok());
  EXPECT_EQ(service.wait(job).state(), v1::CANCELLED);
}

// Whenever the server is killed, also between two runs.
TEST(TargetsKilled, go_on_where_they_were) {
  Service service;
  const std::string job = submit(service, rod(1e-5));
  for (int kills = 1; kills <= 3; ++kills) {
    const auto ended = [&] {
      const v1::Study study = service.study(job);
      return std::ranges::count(study.runs(), v1::SUCCEEDED, &v1::Run::state) >= kills;
    };
    ASSERT_TRUE(eventually(ended));
    service.server().send(SIGKILL);
    service.server().wait();
    service.restart();
  }
  EXPECT_EQ(service.wait(job).state(), v1::SUCCEEDED);
  const v1::Study study = service.study(job);
  std::set<std::string> different;
  for (const v1::Run& run : study.runs()) {
    EXPECT_EQ(run.state(), v1::SUCCEEDED);
    EXPECT_TRUE(different.insert(run.settings(0) + run.settings(1)).second) << "none was run twice";
  }
  EXPECT_LE(std::abs(study.answer().value() - exact), study.answer().band());
}

}  // namespace
}  // namespace trajan::test
