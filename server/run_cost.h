#pragma once

#include <chrono>
#include <string>

#include "trajan/v1/jobs.pb.h"

namespace trajan {

/// The model of the processor, as the operating system names it.
std::string machine_name();

/// From now on large arrays go back to the system as soon as they are freed, and all threads share what is kept of
/// small ones: what a run takes depends on it, and not on the runs before it. To be called before there are
/// threads.
void give_back_freed_memory();

/// What this process has spent since this object was made. One object at a time.
class RunCost {
 public:
  explicit RunCost(int threads);
  v1::Cost so_far() const;

 private:
  const int threads_;
  const std::int64_t own_bytes_;
  const double processor_seconds_;
  const std::chrono::steady_clock::time_point start_;
};

}  // namespace trajan
