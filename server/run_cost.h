#pragma once

#include <chrono>
#include <string>

#include "trajan/v1/jobs.pb.h"

namespace trajan {

/// The model of the processor, as the operating system names it.
std::string machine_name();

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
