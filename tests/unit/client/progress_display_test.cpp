#include "client/progress_display.h"

#include <gtest/gtest.h>

namespace trajan::client {
namespace {

v1::Job job_in(v1::JobState state, std::int64_t last_sequence) {
  v1::Job job;
  job.set_scene_name("bar");
  job.set_state(state);
  job.set_last_sequence(last_sequence);
  return job;
}

v1::Event enters(v1::JobState state, std::int64_t sequence) {
  v1::Event event;
  event.set_sequence(sequence);
  event.set_state(state);
  return event;
}

TEST(ProgressDisplay, TellsNothingTwiceOfAJobThatIsJoinedLate) {
  testing::internal::CaptureStderr();
  ProgressDisplay display(false);
  display.job(job_in(v1::RUNNING, 2));
  display.event(enters(v1::QUEUED, 1));
  display.event(enters(v1::RUNNING, 2));
  display.event(enters(v1::CANCELLING, 3));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "bar: running\nbar: cancelling\n");
}

TEST(ProgressDisplay, TellsAgainWhatAJobGoesThroughAgain) {
  testing::internal::CaptureStderr();
  ProgressDisplay display(false);
  display.job(job_in(v1::QUEUED, 1));
  for (std::int64_t sequence = 2; sequence <= 4; ++sequence)
    display.event(enters(sequence % 2 == 0 ? v1::RUNNING : v1::QUEUED, sequence));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "bar: queued\nbar: running\nbar: queued\nbar: running\n");
}

}  // namespace
}  // namespace trajan::client
