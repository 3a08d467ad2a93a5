#pragma once

#include <chrono>
#include <string>

#include "client/follow_job.h"

namespace trajan::client {

/// One line about where a run stands, at most `width` columns: bar, time, step, rate, energy balance, time left.
std::string progress_line(const std::string& scene, const v1::Progress& progress, int width);

/// Shows a job's life on standard error: on a terminal a bar that redraws itself, otherwise a line for each
/// tenth of the way.
class ProgressDisplay : public JobListener {
 public:
  explicit ProgressDisplay(bool redraws);
  ~ProgressDisplay() override;

  void job(const v1::Job& job) override;
  void event(const v1::Event& event) override;
  void connection_lost() override;

 private:
  void show(const v1::Progress& progress);
  void enter(v1::JobState state);
  void line(const std::string& text);
  void clear();

  const bool redraws_;
  bool bar_is_shown_ = false;
  bool lost_ = false;
  int tenths_ = -1;
  std::string scene_;
  std::int64_t told_ = 0;  ///< events up to this one led to the state that the job was last in
  v1::JobState state_ = v1::JOB_STATE_UNSPECIFIED;
};

/// "QUEUED" as people read it: "queued".
std::string state_name(v1::JobState state);

}  // namespace trajan::client
