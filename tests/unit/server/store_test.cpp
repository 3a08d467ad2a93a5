#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <future>

#include "server/errors.h"
#include "tests/unit/server/store_testing.h"

namespace trajan::store {
namespace {

TEST_F(StoreTest, keeps_what_was_committed_when_it_is_opened_again) {
  {
    Store store(file());
    queue(store);
  }
  Store store(file());
  EXPECT_EQ(look(store, 1).state(), v1::QUEUED);
  EXPECT_EQ(queue(store), "2");
}

TEST_F(StoreTest, undoes_a_change_that_throws_and_no_other_of_its_batch) {
  Store store(file());
  std::promise<void> gate;
  // While the writer waits here, the changes after it gather into one batch.
  store.commit([&](Database&) { gate.get_future().wait(); }, [](std::exception_ptr) {});
  std::vector<std::promise<bool>> failed(3);
  for (int i = 0; i < 3; ++i) {
    store.commit(
        [i](Database& database) {
          v1::SubmitJobRequest request;
          request.set_request_id(std::to_string(i));
          submit(database, request);
          if (i == 1) throw std::runtime_error("on purpose");
        },
        [&failed, i](std::exception_ptr error) { failed[i].set_value(error != nullptr); });
  }
  gate.set_value();
  EXPECT_FALSE(failed[0].get_future().get());
  EXPECT_TRUE(failed[1].get_future().get());
  EXPECT_FALSE(failed[2].get_future().get());
  const auto jobs = store.read([](Database& database) { return list_jobs(database, {}); });
  EXPECT_EQ(jobs.jobs_size(), 2);
}

TEST_F(StoreTest, has_every_job_that_was_acknowledged_before_a_kill) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    Store store(file());
    while (true) {
      const auto job = static_cast<std::int64_t>(std::stoll(queue(store)));
      if (write(ends[1], &job, sizeof job) != sizeof job) _exit(1);
    }
  }
  close(ends[1]);
  std::int64_t acknowledged = 0;
  constexpr std::int64_t enough = 200;
  std::int64_t job = 0;
  while (read(ends[0], &job, sizeof job) == sizeof job) {
    acknowledged = job;
    if (job == enough) kill(child, SIGKILL);
  }
  waitpid(child, nullptr, 0);
  close(ends[0]);
  EXPECT_GE(acknowledged, enough);
  Store store(file());
  for (std::int64_t i = 1; i <= acknowledged; ++i) EXPECT_EQ(look(store, i).state(), v1::QUEUED);
}

TEST_F(StoreTest, gives_jobs_out_by_priority_then_in_the_order_of_submission) {
  Store store(file());
  for (const int priority : {0, 5, 0, 5, -1}) queue(store, priority);
  std::vector<std::int64_t> order;
  for (int i = 0; i < 5; ++i) order.push_back(take(store, "worker " + std::to_string(i))->job);
  EXPECT_THAT(order, testing::ElementsAre(2, 4, 1, 3, 5));
  EXPECT_FALSE(take(store, "late").has_value());
}

TEST_F(StoreTest, gives_a_worker_that_missed_its_lease_the_same_again) {
  Store store(file());
  queue(store);
  queue(store);
  EXPECT_EQ(lease_id(*take(store, "worker")), "1-1");
  EXPECT_EQ(lease_id(*take(store, "worker")), "1-1");
  EXPECT_EQ(lease_id(*take(store, "another")), "2-1");
}

TEST_F(StoreTest, counts_lost_workers_and_fails_a_job_that_loses_too_many) {
  Store store(file());
  queue(store);
  for (int attempt = 1; attempt <= 3; ++attempt) {
    const auto lease = take(store, "worker");
    ASSERT_TRUE(lease.has_value());
    EXPECT_EQ(lease->attempt, attempt);
    store.commit([&](Database& database) { lose(database, *lease, "killed", 3); });
  }
  EXPECT_EQ(look(store, 1).state(), v1::FAILED);
  EXPECT_EQ(look(store, 1).failure().reason(), "WORKER_LOST");
  EXPECT_FALSE(take(store, "worker").has_value());
}

TEST_F(StoreTest, does_not_blame_a_job_for_workers_that_ended_for_other_reasons) {
  Store store(file());
  queue(store);
  for (int attempt = 1; attempt <= 5; ++attempt) {
    const auto lease = take(store, "worker");
    ASSERT_TRUE(lease.has_value());
    store.commit([&](Database& database) { take_back(database, *lease, "the machine was switched off"); });
  }
  EXPECT_EQ(look(store, 1).state(), v1::QUEUED);
}

TEST_F(StoreTest, refuses_words_of_a_lease_that_is_lost) {
  Store store(file());
  queue(store);
  const auto lease = take(store, "worker");
  store.commit([&](Database& database) { lose(database, *lease, "silent", 3); });
  v1::ReportRequest report;
  report.set_lease_id(lease_id(*lease));
  EXPECT_THROW(store.commit([&](Database& database) { record_report(database, report); }), ServiceError);
  v1::CompleteRequest request;
  request.set_lease_id(lease_id(*lease));
  request.mutable_succeeded();
  EXPECT_THROW(store.commit([&](Database& database) { complete(database, request); }), ServiceError);
  EXPECT_EQ(look(store, 1).state(), v1::QUEUED);
}

TEST_F(StoreTest, takes_the_same_outcome_twice) {
  Store store(file());
  queue(store);
  v1::CompleteRequest request;
  request.set_lease_id(lease_id(*take(store, "worker")));
  request.mutable_succeeded();
  for (int i = 0; i < 2; ++i) store.commit([&](Database& database) { complete(database, request); });
  EXPECT_EQ(look(store, 1).state(), v1::SUCCEEDED);
  EXPECT_EQ(look(store, 1).last_sequence(), 3) << "queued, running, succeeded";
}

TEST_F(StoreTest, cancels_a_job_whose_worker_is_lost_while_it_stops) {
  Store store(file());
  queue(store);
  const auto lease = take(store, "worker");
  store.commit([](Database& database) { cancel(database, 1, ""); });
  EXPECT_EQ(look(store, 1).state(), v1::CANCELLING);
  store.commit([&](Database& database) { lose(database, *lease, "killed", 3); });
  EXPECT_EQ(look(store, 1).state(), v1::CANCELLED);
}

TEST_F(StoreTest, numbers_events_without_gaps) {
  Store store(file());
  queue(store);
  v1::ReportRequest report;
  report.set_lease_id(lease_id(*take(store, "worker")));
  report.mutable_progress()->set_step(7);
  report.add_warnings()->set_name("energy");
  store.commit([&](Database& database) { record_report(database, report); });
  const auto events = store.read([](Database& database) { return events_after(database, 1, 1, 100); });
  std::vector<std::int64_t> numbers;
  for (const v1::Event& event : events) numbers.push_back(event.sequence());
  EXPECT_THAT(numbers, testing::ElementsAre(2, 3, 4));
}

TEST_F(StoreTest, keeps_a_warning_of_each_name) {
  Store store(file());
  queue(store);
  v1::ReportRequest report;
  report.set_lease_id(lease_id(*take(store, "worker")));
  report.add_warnings()->set_name("energy");
  for (int i = 0; i < 2; ++i) store.commit([&](Database& database) { record_report(database, report); });
  v1::CompleteRequest request;
  request.set_lease_id(report.lease_id());
  request.mutable_succeeded();
  for (const char* name : {"energy", "locking"}) request.add_warnings()->set_name(name);
  store.commit([&](Database& database) { complete(database, request); });
  const auto is_named = [](const char* name) { return testing::Property(&v1::Warning::name, name); };
  EXPECT_THAT(look(store, 1).warnings(), testing::ElementsAre(is_named("energy"), is_named("locking")));
  EXPECT_EQ(look(store, 1).last_sequence(), 5) << "queued, running, two messages, succeeded";
}

TEST_F(StoreTest, lists_jobs_by_state_and_labels) {
  Store store(file());
  v1::SubmitJobRequest request;
  (*request.mutable_labels())["study"] = "beams";
  (*request.mutable_labels())["mesh"] = "fine";
  store.commit([&](Database& database) { submit(database, request); });
  queue(store);
  v1::ListJobsRequest by_label;
  (*by_label.mutable_labels())["study"] = "beams";
  const auto labelled = store.read([&](Database& database) { return list_jobs(database, by_label); });
  ASSERT_EQ(labelled.jobs_size(), 1);
  EXPECT_EQ(labelled.jobs(0).job_id(), "1");
  v1::ListJobsRequest by_state;
  by_state.add_states(v1::RUNNING);
  EXPECT_EQ(store.read([&](Database& database) { return list_jobs(database, by_state); }).jobs_size(), 0);
  by_state.add_states(v1::QUEUED);
  EXPECT_EQ(store.read([&](Database& database) { return list_jobs(database, by_state); }).jobs_size(), 2);
}

TEST_F(StoreTest, refuses_foreign_page_tokens) {
  Store store(file());
  v1::ListJobsRequest request;
  request.set_page_token("yesterday");
  EXPECT_THROW(store.read([&](Database& database) { return list_jobs(database, request); }), ServiceError);
}

}  // namespace
}  // namespace trajan::store
