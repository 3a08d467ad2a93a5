#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <thread>

#include "tests/service/result_files.h"
#include "tests/service/service.h"

namespace trajan::test {
namespace {

/// The result file of an undisturbed run of the same scene.
v1::Job undisturbed(Service& service, const v1::Scene& scene) {
  const v1::Job job = service.wait(service.submit(scene));
  EXPECT_EQ(job.state(), v1::SUCCEEDED) << job.ShortDebugString();
  EXPECT_EQ(job.attempts(), 1);
  return job;
}

void expect_same_results(const v1::Job& job, const v1::Job& reference) {
  EXPECT_EQ(compare_datasets(job.result().path(), reference.result().path()), "");
  ASSERT_EQ(job.measures_size(), reference.measures_size());
  for (int i = 0; i < job.measures_size(); ++i) EXPECT_EQ(job.measures(i).value(), reference.measures(i).value());
}

TEST(WorkerKilled, its_job_goes_on_from_the_checkpoint_to_the_same_bits) {
  Service service(frequent_checkpoints);
  const v1::Scene scene = bar();
  const std::string job = service.submit(scene);
  service.wait_for_checkpoint(job);
  ASSERT_EQ(service.workers().size(), 1U);
  kill(service.workers()[0], SIGKILL);
  const v1::Job done = service.wait(job);
  EXPECT_EQ(done.state(), v1::SUCCEEDED) << done.ShortDebugString();
  EXPECT_EQ(done.attempts(), 2);
  expect_same_results(done, undisturbed(service, scene));
}

TEST(WorkerKilled, a_job_that_loses_every_worker_fails) {
  Service service({"--checkpoint-interval", "1000"});
  const std::string job = service.submit(bar(1000));
  std::vector<v1::Event> events;
  v1::Job last;
  int kills = 0;
  const auto kill_when_running = [&](const v1::WatchJobResponse& response) {
    if (response.has_event() && response.event().state() == v1::RUNNING) {
      for (const pid_t worker : service.workers()) kill(worker, SIGKILL);
      ++kills;
    }
    return false;
  };
  EXPECT_TRUE(service.watch(job, events, last, kill_when_running).ok());
  EXPECT_EQ(last.state(), v1::FAILED);
  EXPECT_EQ(last.failure().reason(), "WORKER_LOST");
  EXPECT_EQ(last.attempts(), 3);
  EXPECT_EQ(kills, 3);
}

TEST(WorkerHung, is_ended_by_force_and_its_job_goes_on) {
  Service service({"--checkpoint-interval", "0.2", "--lease", "1"});
  const std::string job = service.submit(bar());
  service.wait_for_checkpoint(job);
  ASSERT_EQ(service.workers().size(), 1U);
  kill(service.workers()[0], SIGSTOP);
  const v1::Job done = service.wait(job);
  EXPECT_EQ(done.state(), v1::SUCCEEDED) << done.ShortDebugString();
  EXPECT_EQ(done.attempts(), 2);
}

TEST(ServerKilled, running_jobs_finish_and_watchers_miss_and_repeat_nothing) {
  Service service(frequent_checkpoints);
  const v1::Scene scene = bar();
  const std::string running = service.submit(scene);
  const std::string waiting = service.submit(bar(0.001, 20));
  std::vector<v1::Event> events;
  v1::Job last;
  service.watch(running, events, last, [&](const v1::WatchJobResponse& response) {
    if (response.event().progress().rows() > 0) service.server().send(SIGKILL);
    return false;
  });
  EXPECT_EQ(service.server().wait(), -SIGKILL);
  ASSERT_EQ(service.workers().size(), 1U) << "the worker lives on";
  service.restart();
  EXPECT_TRUE(service.watch(running, events, last).ok());
  EXPECT_EQ(last.state(), v1::SUCCEEDED) << last.ShortDebugString();
  EXPECT_EQ(last.attempts(), 1) << "the same worker went on";
  for (std::size_t i = 0; i < events.size(); ++i) {
    ASSERT_EQ(events[i].sequence(), static_cast<std::int64_t>(i + 1));
  }
  EXPECT_EQ(last.last_sequence(), std::ssize(events));
  EXPECT_EQ(service.wait(waiting).state(), v1::SUCCEEDED);
  EXPECT_TRUE(eventually([&] { return service.workers().size() == 1; })) << "adopted workers count";
  expect_same_results(last, undisturbed(service, scene));
}

TEST(ServerKilled, acknowledged_jobs_are_not_lost) {
  Service service({"--workers", "0"});
  int acknowledged = 0;
  std::thread killer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    service.server().send(SIGKILL);
  });
  try {
    while (true) {
      service.submit(bar(0.001, 20));
      ++acknowledged;
    }
  } catch (const std::runtime_error&) {
    // The server is gone.
  }
  killer.join();
  service.server().wait();
  service.restart();
  EXPECT_GT(acknowledged, 0);
  for (int job = 1; job <= acknowledged; ++job) EXPECT_EQ(service.get(std::to_string(job)).state(), v1::QUEUED);
}

/// The bar pulled little by little, in analyses that have no motion.
v1::Scene pulled(const std::string& analysis) {
  v1::Scene scene = bar();
  const double length = scene.analysis().end_time();
  // Long enough to be killed: a level of a relaxation takes many steps. Snapshots are at every fourth part.
  const int quarter = analysis == "relaxation" ? 50 : 300;
  const int levels = 4 * std::max(3, static_cast<int>(quarter / slowness()));
  scene.mutable_bodies(0)->clear_initial_velocity();
  scene.mutable_boundaries(0)->mutable_fixed()->clear_axes();
  v1::Load& load = *scene.add_loads();
  load.set_name("pull");
  load.mutable_body_force()->mutable_acceleration()->set_x(1);
  load.mutable_time()->mutable_ramp()->set_duration(length);
  scene.mutable_outputs()->set_samples(levels);
  if (analysis == "relaxation") scene.mutable_analysis()->mutable_relaxation();
  if (analysis == "quasi_static") scene.mutable_analysis()->mutable_quasi_static()->set_load_steps(levels);
  return scene;
}

class EverythingKilled : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Analyses, EverythingKilled, testing::Values("relaxation", "quasi_static"),
                         [](const auto& named) { return named.param; });

TEST_P(EverythingKilled, jobs_go_on_from_their_checkpoints_to_the_same_bits) {
  Service service(frequent_checkpoints);
  const v1::Scene scene = pulled(GetParam());
  const std::string job = service.submit(scene);
  service.wait_for_checkpoint(job);
  service.server().send(SIGKILL);
  service.server().wait();
  for (const pid_t worker : service.workers()) kill(worker, SIGKILL);
  ASSERT_TRUE(eventually([&] { return service.workers().empty(); }));
  service.restart();
  const v1::Job done = service.wait(job);
  EXPECT_EQ(done.state(), v1::SUCCEEDED) << done.ShortDebugString();
  EXPECT_EQ(done.attempts(), 2);
  expect_same_results(done, undisturbed(service, scene));
}

TEST(IdleWorkers, of_a_killed_server_leave_when_the_next_one_comes) {
  Service service;
  ASSERT_TRUE(eventually([&] { return service.workers().size() == 1; }));
  const pid_t orphan = service.workers()[0];
  service.server().send(SIGKILL);
  service.server().wait();
  service.restart();
  EXPECT_TRUE(eventually([&] {
    const auto workers = service.workers();
    return workers.size() == 1 && workers[0] != orphan;
  }));
}

}  // namespace
}  // namespace trajan::test
