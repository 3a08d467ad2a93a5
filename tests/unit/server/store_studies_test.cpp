#include "server/store_studies.h"

#include <gmock/gmock.h>

#include "server/errors.h"
#include "server/scene_digest.h"
#include "server/store_findings.h"
#include "tests/unit/server/store_testing.h"

namespace trajan::store {
namespace {

using testing::ElementsAre;

class StudiesTest : public StoreTest {
 protected:
  /// A sweep over cell sizes.
  static std::string study(Store& store, const std::vector<double>& cell_sizes, bool run_all = false,
                           const std::string& request_id = "") {
    v1::SubmitStudyRequest request;
    request.mutable_scene()->set_name("beam");
    request.set_run_all(run_all);
    request.set_request_id(request_id);
    StudyPlan plan{"sweep", {}, {}};
    plan.study.add_dials("domain.cell_size");
    for (const double size : cell_sizes) {
      PlannedRun& planned = plan.runs.emplace_back(PlannedRun{{}, request.scene()});
      planned.run.add_settings(std::to_string(size));
      planned.scene.mutable_domain()->set_cell_size(size);
    }
    v1::Job job;
    store.commit([&](Database& database) { job = submit_study(database, request, plan); });
    return job.job_id();
  }

  static v1::Study table(Store& store, const std::string& study) {
    return store.read([&](Database& database) { return get_study(database, job_number(study)); });
  }

  /// Computes the next job; its measure is the cell size.
  static std::string compute(Store& store) {
    const auto lease = take(store, "worker");
    if (!lease) return {};
    v1::CompleteRequest request;
    request.set_lease_id(lease_id(*lease));
    request.mutable_cost()->set_core_seconds(2);
    request.mutable_cost()->set_machine("a machine");
    v1::MeasureValue& measure = *request.mutable_succeeded()->add_measures();
    measure.set_name("size");
    measure.set_value(
        store.read([&](Database& database) { return get_scene(database, lease->job); }).domain().cell_size());
    measure.set_error(-0.5);
    store.commit([&](Database& database) { complete(database, request); });
    return std::to_string(lease->job);
  }

  static void fail_next(Store& store) {
    v1::CompleteRequest request;
    request.set_lease_id(lease_id(*take(store, "worker")));
    request.mutable_failed()->set_reason("DIVERGED");
    store.commit([&](Database& database) { complete(database, request); });
  }

  static v1::Job cancel_it(Store& store, std::int64_t job) {
    v1::Job answer;
    store.commit([&](Database& database) { answer = cancel(database, job, ""); });
    return answer;
  }
};

TEST_F(StudiesTest, follow_their_runs_and_are_never_leased) {
  Store store(file());
  const std::string parent = study(store, {0.5, 0.25});
  EXPECT_EQ(look(store, 1).state(), v1::QUEUED);
  EXPECT_EQ(compute(store), "2") << "the study itself, 1, came first";
  EXPECT_EQ(look(store, 1).state(), v1::RUNNING);
  EXPECT_EQ(look(store, 1).study().succeeded(), 1);
  EXPECT_EQ(compute(store), "3");
  EXPECT_EQ(compute(store), "");
  EXPECT_EQ(look(store, 1).state(), v1::SUCCEEDED);
  const v1::Study found = table(store, parent);
  ASSERT_EQ(found.runs_size(), 2);
  EXPECT_EQ(found.runs(1).measures(0).value(), 0.25);
  EXPECT_EQ(found.runs(1).cost().core_seconds(), 2);
  EXPECT_THAT(found.runs(1).settings(), ElementsAre(std::to_string(0.25)));
}

TEST_F(StudiesTest, tell_their_events_without_gaps) {
  Store store(file());
  study(store, {0.5, 0.25});
  while (!compute(store).empty()) {
  }
  const auto events = store.read([](Database& database) { return events_after(database, 1, 0, 100); });
  for (std::size_t i = 0; i < events.size(); ++i)
    EXPECT_EQ(events[i].sequence(), static_cast<std::int64_t>(i + 1));
  EXPECT_EQ(events.back().state(), v1::SUCCEEDED);
}

TEST_F(StudiesTest, fail_with_one_of_their_runs_after_the_others) {
  Store store(file());
  study(store, {0.5, 0.25});
  fail_next(store);
  EXPECT_EQ(look(store, 1).state(), v1::RUNNING);
  compute(store);
  EXPECT_EQ(look(store, 1).state(), v1::FAILED);
  EXPECT_EQ(look(store, 1).failure().reason(), "RUNS_FAILED");
}

TEST_F(StudiesTest, are_cancelled_with_all_of_their_runs) {
  Store store(file());
  study(store, {0.5, 0.25, 0.125});
  compute(store);
  const auto running = take(store, "worker");
  EXPECT_EQ(cancel_it(store, 1).state(), v1::CANCELLING);
  EXPECT_EQ(look(store, 3).state(), v1::CANCELLING);
  EXPECT_EQ(look(store, 4).state(), v1::CANCELLED);
  v1::CompleteRequest request;
  request.set_lease_id(lease_id(*running));
  request.mutable_cancelled();
  store.commit([&](Database& database) { complete(database, request); });
  EXPECT_EQ(look(store, 1).state(), v1::CANCELLED);
}

TEST_F(StudiesTest, are_removed_with_their_runs_and_not_without) {
  Store store(file());
  study(store, {0.5, 0.25});
  while (!compute(store).empty()) {
  }
  EXPECT_THROW(store.commit([](Database& database) { remove_job(database, 2); }), ServiceError);
  std::vector<std::int64_t> removed;
  store.commit([&](Database& database) { removed = remove_job(database, 1); });
  EXPECT_THAT(removed, ElementsAre(2, 3, 1));
  EXPECT_FALSE(store.read([](Database& database) { return exists(database, 3); }));
}

TEST_F(StudiesTest, are_listed_without_their_runs_unless_they_are_asked_for) {
  Store store(file());
  study(store, {0.5, 0.25});
  queue(store);
  const auto list = [&](const v1::ListJobsRequest& request) {
    return store.read([&](Database& database) { return list_jobs(database, request); }).jobs_size();
  };
  v1::ListJobsRequest request;
  EXPECT_EQ(list(request), 2);
  request.set_with_runs(true);
  EXPECT_EQ(list(request), 4);
  request.set_parent_id("1");
  EXPECT_EQ(list(request), 2);
}

TEST_F(StudiesTest, take_over_what_has_been_computed_already) {
  Store store(file());
  study(store, {0.5, 0.25});
  while (!compute(store).empty()) {
  }
  const std::string again = study(store, {0.25, 0.125});
  const v1::Study found = table(store, again);
  EXPECT_EQ(found.runs(0).state(), v1::SUCCEEDED);
  EXPECT_EQ(found.runs(0).answered_by(), "3");
  EXPECT_EQ(found.runs(0).measures(0).value(), 0.25);
  EXPECT_EQ(found.runs(1).state(), v1::QUEUED);
  EXPECT_EQ(table(store, study(store, {0.25}, true)).runs(0).state(), v1::QUEUED) << "opted out";
}

TEST_F(StudiesTest, that_are_answered_altogether_end_at_once) {
  Store store(file());
  study(store, {0.5});
  compute(store);
  const std::string again = study(store, {0.5});
  EXPECT_EQ(table(store, again).job().state(), v1::SUCCEEDED);
}

TEST_F(StudiesTest, wait_for_an_equal_scene_that_is_computed) {
  Store store(file());
  study(store, {0.5, 0.25});
  study(store, {0.5});
  const auto first = take(store, "one");
  EXPECT_EQ(take(store, "another")->job, 3);
  EXPECT_FALSE(take(store, "a third").has_value()) << "job 5 waits for job 2";
  v1::CompleteRequest request;
  request.set_lease_id(lease_id(*first));
  request.mutable_succeeded();
  store.commit([&](Database& database) { complete(database, request); });
  EXPECT_EQ(look(store, 5).answered_by(), "2");
  EXPECT_EQ(look(store, 4).state(), v1::SUCCEEDED);
}

TEST_F(StudiesTest, compute_what_another_job_failed_to_compute) {
  Store store(file());
  study(store, {0.5});
  study(store, {0.5});
  fail_next(store);
  EXPECT_EQ(compute(store), "4");
}

TEST_F(StudiesTest, keep_the_numbers_of_an_answer_whose_files_are_removed) {
  Store store(file());
  study(store, {0.5});
  compute(store);
  study(store, {0.5});
  store.commit([](Database& database) { remove_job(database, 1); });
  EXPECT_EQ(look(store, 4).measures_size(), 1);
  EXPECT_FALSE(look(store, 4).has_result());
}

TEST_F(StudiesTest, are_the_same_for_the_same_request_id) {
  Store store(file());
  EXPECT_EQ(study(store, {0.5}, false, "once"), "1");
  EXPECT_EQ(study(store, {0.5}, false, "once"), "1");
  EXPECT_THROW(study(store, {0.5}, true, "once"), ServiceError);
}

TEST_F(StudiesTest, leave_findings_of_their_family_behind) {
  Store store(file());
  study(store, {0.5, 0.25});
  while (!compute(store).empty()) {
  }
  store.commit([](Database& database) { remove_job(database, 1); });
  v1::Scene scene;
  scene.set_name("another name");
  scene.mutable_domain()->set_cell_size(7);
  const auto found =
      store.read([&](Database& database) { return findings(database, family_digest(scene), "a machine"); });
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].settings().cell_size(), 0.5);
  EXPECT_EQ(found[0].error(), 0.5) << "a magnitude";
  EXPECT_EQ(found[0].cost().core_seconds(), 2);
  EXPECT_TRUE(store.read([&](Database& database) { return findings(database, "?", ""); }).empty());
}

TEST_F(StudiesTest, are_told_apart_from_jobs) {
  Store store(file());
  const std::string job = queue(store);
  EXPECT_THROW(table(store, job), ServiceError);
}

// Version 1 had the table of jobs without studies.
TEST_F(StudiesTest, come_to_a_store_of_an_earlier_version) {
  { Store store(file()); }
  Database(file()).execute(R"sql(
    DROP INDEX queued; DROP INDEX runs; DROP INDEX scenes; DROP INDEX answers; DROP TABLE findings;
    ALTER TABLE jobs DROP COLUMN is_study; ALTER TABLE jobs DROP COLUMN parent; ALTER TABLE jobs DROP COLUMN plan;
    ALTER TABLE jobs DROP COLUMN reuse; ALTER TABLE jobs DROP COLUMN scene;
    ALTER TABLE jobs DROP COLUMN answered_by; DROP TABLE predictions; DROP TABLE calibrations;
    CREATE INDEX queued ON jobs(priority DESC, job_id) WHERE state = 1;
    INSERT INTO jobs(state, priority, losses, process_id, job, request) VALUES (1, 0, 0, 0, x'0a0131', x'');
    PRAGMA user_version = 1)sql");
  Store store(file());
  study(store, {0.5});
  EXPECT_EQ(compute(store), "1") << "the job of the earlier version";
  EXPECT_EQ(compute(store), "3");
}

}  // namespace
}  // namespace trajan::store
