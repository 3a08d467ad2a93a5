#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "tests/service/service.h"

namespace trajan::test::studies_test {
namespace {

grpc::Status cancel(Service& service, const std::string& job) {
  v1::CancelJobRequest request;
  request.set_job_id(job);
  grpc::ClientContext context;
  v1::Job answer;
  return service.jobs().CancelJob(&context, request, &answer);
}

TEST(Studies, run_to_their_end_with_a_table_and_an_event_for_every_run) {
  Service service;
  const std::string job = service.sweep(bar(0.001, 20), {1, 0.5});
  std::vector<v1::Event> events;
  v1::Job last;
  ASSERT_TRUE(service.watch(job, events, last).ok());
  EXPECT_EQ(last.state(), v1::SUCCEEDED) << last.ShortDebugString();
  EXPECT_EQ(last.last_sequence(), std::ssize(events));
  const v1::Study study = service.study(job);
  ASSERT_EQ(study.runs_size(), 2);
  for (const v1::Run& run : study.runs()) {
    EXPECT_EQ(run.state(), v1::SUCCEEDED);
    EXPECT_EQ(run.measures_size(), 1);
    EXPECT_GT(run.cost().core_seconds(), 0);
    EXPECT_GT(run.cost().peak_memory_bytes(), 1 << 20);
    EXPECT_NE(run.cost().machine(), "");
    EXPECT_EQ(service.get(run.job_id()).parent_id(), job);
  }
  EXPECT_NE(study.runs(0).measures(0).value(), study.runs(1).measures(0).value());
}

TEST(Studies, give_an_answer_with_its_files_without_computing_it_again) {
  Service service;
  const std::string first = service.sweep(bar(0.001, 20), {1});
  service.wait(first);
  const std::string computed = service.study(first).runs(0).job_id();
  const std::string again = service.sweep(bar(0.001, 20), {1});
  EXPECT_EQ(service.get(again).state(), v1::SUCCEEDED) << "at once";
  const v1::Run run = service.study(again).runs(0);
  EXPECT_EQ(run.answered_by(), computed);
  EXPECT_EQ(service.get(run.job_id()).attempts(), 0);
  EXPECT_EQ(service.history(run.job_id(), false), service.history(computed, false));
}

TEST(Studies, begin_with_the_settings_of_a_preset_but_have_no_target) {
  Service service({"--workers", "0"});
  v1::SubmitStudyRequest request;
  *request.mutable_scene() = bar();
  request.mutable_fidelity()->set_preset(v1::PREVIEW);
  v1::Dial& dial = *request.mutable_sweep()->add_dials();
  dial.set_name("scheme");
  dial.add_settings()->set_name("USL");
  dial.mutable_settings(0)->add_changes("numerics.scheme=USL");
  const auto stub = v1::Studies::NewStub(service.channel());
  v1::Job job;
  {
    grpc::ClientContext context;
    ASSERT_TRUE(stub->SubmitStudy(&context, request, &job).ok());
  }
  const v1::Settings settings = service.get(service.study(job.job_id()).runs(0).job_id()).settings();
  EXPECT_EQ(settings.cell_size(), 2 * bar().domain().cell_size());
  EXPECT_EQ(settings.numerics().scheme(), "USL");
  request.mutable_fidelity()->mutable_target()->set_measure("tip");
  grpc::ClientContext context;
  EXPECT_EQ(stub->SubmitStudy(&context, request, &job).error_code(), grpc::StatusCode::INVALID_ARGUMENT);
}

TEST(Studies, stop_all_of_their_runs_when_they_are_cancelled) {
  Service service(frequent_checkpoints);
  const std::string job = service.sweep(bar(1000), {1, 2});
  const std::string running = service.study(job).runs(0).job_id();
  service.wait_for_checkpoint(running);
  EXPECT_TRUE(cancel(service, job).ok());
  EXPECT_EQ(service.wait(job).state(), v1::CANCELLED);
  const v1::Study study = service.study(job);
  for (const v1::Run& run : study.runs()) EXPECT_EQ(run.state(), v1::CANCELLED);
}

TEST(StudiesKilled, go_on_where_they_were) {
  Service service(frequent_checkpoints);
  const std::string job = service.sweep(bar(), {0.001, 1, 0.002});
  const std::string first = service.study(job).runs(0).job_id();
  const std::string second = service.study(job).runs(1).job_id();
  service.wait_for_checkpoint(second);
  const v1::Job before = service.get(first);
  EXPECT_EQ(before.state(), v1::SUCCEEDED);
  service.server().send(SIGKILL);
  service.server().wait();
  for (const pid_t worker : service.workers()) kill(worker, SIGKILL);
  ASSERT_TRUE(eventually([&] { return service.workers().empty(); }));
  service.restart();
  EXPECT_EQ(service.wait(job).state(), v1::SUCCEEDED);
  EXPECT_EQ(service.get(first).ended().nanos(), before.ended().nanos()) << "what had ended was not run again";
  EXPECT_EQ(service.get(second).attempts(), 2);
  const v1::Study study = service.study(job);
  for (const v1::Run& run : study.runs()) EXPECT_EQ(run.state(), v1::SUCCEEDED);
}

}  // namespace
}  // namespace trajan::test::studies_test
