#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "proto/crc32c.h"
#include "solver/results/digest.h"
#include "tests/service/service.h"

namespace trajan::test {
namespace {

/// Few steps: ends at once.
v1::Scene short_bar() { return bar(0.001, 20); }

std::string read_result(Service& service, const std::string& job, std::int64_t offset,
                        v1::ReadResultResponse* first = nullptr) {
  v1::ReadResultRequest request;
  request.set_job_id(job);
  request.set_offset(offset);
  grpc::ClientContext context;
  const auto stream = service.jobs().ReadResult(&context, request);
  v1::ReadResultResponse response;
  std::string bytes;
  while (stream->Read(&response)) {
    if (first != nullptr && bytes.empty()) *first = response;
    EXPECT_EQ(response.offset(), offset + std::ssize(bytes));
    EXPECT_EQ(response.crc32c(), crc32c(response.data()));
    bytes += response.data();
  }
  EXPECT_TRUE(stream->Finish().ok());
  return bytes;
}

v1::Job cancel(Service& service, const std::string& job) {
  v1::CancelJobRequest request;
  request.set_job_id(job);
  request.set_reason("a test");
  grpc::ClientContext context;
  v1::Job answer;
  EXPECT_TRUE(service.jobs().CancelJob(&context, request, &answer).ok());
  return answer;
}

grpc::Status remove(Service& service, const std::string& job) {
  v1::DeleteJobRequest request;
  request.set_job_id(job);
  grpc::ClientContext context;
  v1::DeleteJobResponse answer;
  return service.jobs().DeleteJob(&context, request, &answer);
}

void expect_dense(const std::vector<v1::Event>& events) {
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(events[i].sequence(), static_cast<std::int64_t>(i + 1));
  }
}

TEST(Jobs, run_to_their_end_with_measures_a_dense_log_and_a_result_file) {
  Service service;
  const std::string job = service.submit(short_bar());
  std::vector<v1::Event> events;
  v1::Job last;
  ASSERT_TRUE(service.watch(job, events, last).ok());
  EXPECT_EQ(last.state(), v1::SUCCEEDED) << last.ShortDebugString();
  EXPECT_EQ(last.attempts(), 1);
  ASSERT_EQ(last.measures_size(), 1);
  EXPECT_EQ(last.measures(0).name(), "tip");
  EXPECT_TRUE(last.result().complete());
  EXPECT_EQ(last.last_sequence(), std::ssize(events));
  expect_dense(events);
  EXPECT_EQ(events.front().state(), v1::QUEUED);
  EXPECT_EQ(events.back().state(), v1::SUCCEEDED);
}

TEST(Jobs, give_the_same_history_live_and_stored) {
  Service service({"--checkpoint-interval", "1000"});
  const std::string job = service.submit(bar(0.2, 1000));
  const std::vector<double> live = service.history(job, true);
  const std::vector<double> stored = service.history(job, false);
  EXPECT_EQ(live, stored);
  constexpr std::size_t rows = 1001;
  constexpr std::size_t columns = 12;  // 4 of the probe, 6 energies, 2 of momentum
  EXPECT_EQ(stored.size(), rows * columns);
}

TEST(Jobs, give_chosen_columns_from_any_row_on) {
  Service service;
  const std::string job = service.submit(short_bar());
  service.wait(job);
  v1::StreamHistoryRequest request;
  request.set_job_id(job);
  request.add_columns("tip.velocity");
  request.add_columns("energies.kinetic");
  request.set_first_row(15);
  grpc::ClientContext context;
  const auto stream = service.jobs().StreamHistory(&context, request);
  v1::StreamHistoryResponse response;
  ASSERT_TRUE(stream->Read(&response));
  EXPECT_THAT(response.columns(), testing::ElementsAre("tip.velocity.x", "tip.velocity.y", "energies.kinetic"));
  EXPECT_EQ(response.first_row(), 15);
  EXPECT_EQ(response.time_size(), 6);
  EXPECT_EQ(response.values_size(), 18);
}

TEST(Jobs, name_the_columns_there_are_if_one_is_unknown) {
  Service service;
  const std::string job = service.submit(short_bar());
  service.wait(job);
  v1::StreamHistoryRequest request;
  request.set_job_id(job);
  request.add_columns("tap");
  grpc::ClientContext context;
  const auto stream = service.jobs().StreamHistory(&context, request);
  v1::StreamHistoryResponse response;
  EXPECT_FALSE(stream->Read(&response));
  const grpc::Status status = stream->Finish();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_THAT(status.error_message(), testing::HasSubstr("tip.displacement.x"));
}

TEST(Jobs, give_their_result_file_whole_or_from_an_offset) {
  Service service;
  const std::string job = service.submit(short_bar());
  const v1::Job done = service.wait(job);
  v1::ReadResultResponse first;
  const std::string bytes = read_result(service, job, 0, &first);
  EXPECT_EQ(first.total_size(), std::ssize(bytes));
  EXPECT_EQ(first.sha256(), results::sha256(bytes));
  EXPECT_EQ(done.result().sha256(), first.sha256());
  std::ifstream file(done.result().path(), std::ios::binary);
  EXPECT_EQ(bytes, std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>()));
  EXPECT_EQ(read_result(service, job, 1000), bytes.substr(1000));
}

TEST(Jobs, tell_of_a_damaged_result_file) {
  Service service;
  const std::string job = service.submit(short_bar());
  const v1::Job done = service.wait(job);
  std::fstream file(done.result().path(), std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(done.result().size() / 2);
  file.put('\x5a').put('\xa5').flush();
  v1::ReadResultRequest request;
  request.set_job_id(job);
  grpc::ClientContext context;
  const auto stream = service.jobs().ReadResult(&context, request);
  v1::ReadResultResponse response;
  while (stream->Read(&response)) {
  }
  EXPECT_EQ(stream->Finish().error_code(), grpc::StatusCode::DATA_LOSS);
}

TEST(Jobs, are_the_same_for_the_same_request_id_and_request) {
  Service service({"--workers", "0"});
  v1::SubmitJobRequest request;
  *request.mutable_scene() = short_bar();
  request.set_request_id("once");
  (*request.mutable_labels())["a"] = "1";
  (*request.mutable_labels())["b"] = "2";
  std::set<std::string> ids;
  for (int i = 0; i < 3; ++i) {
    grpc::ClientContext context;
    v1::Job job;
    ASSERT_TRUE(service.jobs().SubmitJob(&context, request, &job).ok());
    ids.insert(job.job_id());
  }
  EXPECT_THAT(ids, testing::ElementsAre("1"));
  request.set_priority(1);
  grpc::ClientContext context;
  v1::Job job;
  EXPECT_EQ(service.jobs().SubmitJob(&context, request, &job).error_code(), grpc::StatusCode::ALREADY_EXISTS);
  EXPECT_EQ(details(context).reason(), "REQUEST_ID_IN_USE");
}

TEST(Jobs, are_listed_newest_first_in_pages) {
  Service service({"--workers", "0"});
  for (int i = 0; i < 5; ++i) service.submit(short_bar());
  v1::ListJobsRequest request;
  request.set_page_size(2);
  std::vector<std::string> ids;
  do {
    grpc::ClientContext context;
    v1::ListJobsResponse page;
    ASSERT_TRUE(service.jobs().ListJobs(&context, request, &page).ok());
    EXPECT_LE(page.jobs_size(), 2);
    for (const v1::Job& job : page.jobs()) ids.push_back(job.job_id());
    request.set_page_token(page.next_page_token());
  } while (!request.page_token().empty());
  EXPECT_THAT(ids, testing::ElementsAre("5", "4", "3", "2", "1"));
}

TEST(Jobs, that_wait_are_cancelled_at_once) {
  Service service({"--workers", "0"});
  const std::string job = service.submit(short_bar());
  EXPECT_EQ(cancel(service, job).state(), v1::CANCELLED);
  EXPECT_EQ(cancel(service, job).state(), v1::CANCELLED);
}

TEST(Jobs, that_run_are_cancelled_and_keep_what_they_recorded) {
  Service service({"--checkpoint-interval", "0.2"});
  const std::string job = service.submit(bar(1000));
  service.wait_for_checkpoint(job);
  EXPECT_EQ(cancel(service, job).state(), v1::CANCELLING);
  const v1::Job done = service.wait(job);
  EXPECT_EQ(done.state(), v1::CANCELLED);
  EXPECT_FALSE(done.result().complete());
  EXPECT_FALSE(service.history(job, false).empty());
  EXPECT_EQ(std::ssize(read_result(service, job, 0)), done.result().size());
}

TEST(Jobs, are_deleted_with_their_files_once_they_have_ended) {
  Service service({"--workers", "0"});
  const std::string job = service.submit(short_bar());
  EXPECT_EQ(remove(service, job).error_code(), grpc::StatusCode::FAILED_PRECONDITION);
  cancel(service, job);
  std::filesystem::create_directories(service.job_directory(job));
  EXPECT_TRUE(remove(service, job).ok());
  EXPECT_FALSE(std::filesystem::exists(service.job_directory(job)));
  EXPECT_EQ(remove(service, job).error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_EQ(service.submit(short_bar()), "2") << "numbers are not used again";
}

TEST(Jobs, are_refused_with_all_violations_of_an_invalid_scene) {
  Service service({"--workers", "0"});
  v1::SubmitJobRequest request;
  *request.mutable_scene() = short_bar();
  request.mutable_scene()->mutable_domain()->set_cell_size(-1);
  request.mutable_scene()->mutable_analysis()->set_end_time(0);
  grpc::ClientContext context;
  v1::Job job;
  EXPECT_EQ(service.jobs().SubmitJob(&context, request, &job).error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  std::set<std::string> paths;
  const v1::ErrorDetails found = details(context);
  EXPECT_EQ(found.reason(), "INVALID_SCENE");
  for (const v1::Violation& violation : found.violations()) paths.insert(violation.path());
  EXPECT_TRUE(paths.contains("domain.cell_size"));
  EXPECT_TRUE(paths.contains("analysis.end_time"));
}

TEST(Jobs, are_refused_if_the_scene_is_larger_than_a_message_may_be) {
  Service service({"--workers", "0"});
  v1::SubmitJobRequest request;
  *request.mutable_scene() = short_bar();
  request.mutable_scene()->set_description(std::string(17 << 20, 'x'));
  grpc::ClientContext context;
  v1::Job job;
  EXPECT_EQ(service.jobs().SubmitJob(&context, request, &job).error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
}

TEST(Scenes, are_checked_without_being_queued) {
  Service service({"--workers", "0"});
  v1::CheckSceneRequest request;
  *request.mutable_scene() = short_bar();
  v1::CheckSceneResponse valid;
  grpc::ClientContext first;
  ASSERT_TRUE(service.jobs().CheckScene(&first, request, &valid).ok());
  EXPECT_EQ(valid.violations_size(), 0);
  EXPECT_EQ(valid.plan().particles(), 40 * 4 * 4);
  request.mutable_scene()->mutable_domain()->set_cell_size(-1);
  v1::CheckSceneResponse invalid;
  grpc::ClientContext second;
  ASSERT_TRUE(service.jobs().CheckScene(&second, request, &invalid).ok());
  EXPECT_GT(invalid.violations_size(), 0);
  EXPECT_FALSE(invalid.has_plan());
}

TEST(Watchers, are_refused_for_what_does_not_exist) {
  Service service({"--workers", "0"});
  std::vector<v1::Event> events;
  v1::Job last;
  EXPECT_EQ(service.watch("7", events, last).error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_EQ(service.watch("seven", events, last).error_code(), grpc::StatusCode::NOT_FOUND);
  const std::string job = service.submit(short_bar());
  events.emplace_back().set_sequence(100);
  EXPECT_EQ(service.watch(job, events, last).error_code(), grpc::StatusCode::OUT_OF_RANGE);
}

TEST(Watchers, hear_a_heartbeat_while_nothing_happens) {
  Service service({"--workers", "0"});
  const std::string job = service.submit(short_bar());
  std::vector<v1::Event> events;
  v1::Job last;
  const auto status =
      service.watch(job, events, last, [](const auto& response) { return response.has_heartbeat(); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::CANCELLED);
}

}  // namespace
}  // namespace trajan::test
