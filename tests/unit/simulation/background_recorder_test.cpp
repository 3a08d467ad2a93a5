#include "solver/analyses/background_recorder.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "solver/simulation/simulation.h"
#include "tests/unit/simulation/scenes.h"

namespace trajan {
namespace {

/// Holds every snapshot until it is let go.
class SlowMemory : public test::Memory {
 public:
  void snapshot(std::int64_t row, const Snapshot& snapshot) override {
    held_ = true;
    go_.wait(false);
    test::Memory::snapshot(row, snapshot);
    held_ = false;
  }
  void let_go() {
    go_ = true;
    go_.notify_all();
  }
  bool held() const { return held_; }

 private:
  std::atomic<bool> go_ = false, held_ = false;
};

Scene recorded_discs() {
  Scene scene = test::discs(0.1);
  scene.outputs.snapshots = 5;
  return scene;
}

TEST(BackgroundRecorder, LetsTheSolverTakeStepsWhileASnapshotIsStored) {
  const Model model = validate(recorded_discs());
  SlowMemory slow;
  std::int64_t steps_while_held = 0;
  BackgroundRecorder background(slow);
  background.snapshot(0, {});
  while (!slow.held()) std::this_thread::yield();
  Simulation simulation(model, 1);
  while (!simulation.step()) ++steps_while_held;
  background.sample(0, 0, simulation.columns());
  EXPECT_TRUE(slow.held());
  EXPECT_GT(steps_while_held, 0);
  EXPECT_EQ(background.durable_rows(), 0);
  slow.let_go();
  background.finish();
  EXPECT_EQ(slow.snapshots.size(), 1u);
  EXPECT_EQ(background.durable_rows(), 1);
}

TEST(BackgroundRecorder, StoresWhatTheRunGivesInItsOrder) {
  const Model model = validate(recorded_discs());
  RunOptions options;
  options.checkpoint_interval = 0;
  test::Memory direct, stored;
  run(model, options, direct, nullptr);
  BackgroundRecorder background(stored);
  run(model, options, background, nullptr);
  background.finish();
  EXPECT_EQ(stored.times, direct.times);
  EXPECT_EQ(stored.rows, direct.rows);
  ASSERT_EQ(stored.snapshots.size(), direct.snapshots.size());
  for (std::size_t i = 0; i < stored.snapshots.size(); ++i) {
    EXPECT_EQ(stored.snapshots[i].time, direct.snapshots[i].time);
    EXPECT_EQ(stored.snapshots[i].position, direct.snapshots[i].position);
  }
  EXPECT_EQ(stored.checkpoints.size(), direct.checkpoints.size());
}

class FullDisk : public test::Memory {
 public:
  void sample(std::int64_t, double, std::span<const double>) override { throw std::runtime_error("disk full"); }
};

TEST(BackgroundRecorder, ThrowsWhatTheOtherOneThrewAndStoresNothingAfterIt) {
  FullDisk full;
  BackgroundRecorder background(full);
  background.sample(0, 0, {});
  EXPECT_THROW(background.finish(), std::runtime_error);
  EXPECT_THROW(background.snapshot(0, {}), std::runtime_error);
  EXPECT_THROW(background.checkpoint({}), std::runtime_error);
  EXPECT_TRUE(full.snapshots.empty() && full.checkpoints.empty());
}

}  // namespace
}  // namespace trajan
