#pragma once

#include <string>
#include <vector>

#include "trajan/v1/jobs.pb.h"

namespace trajan::client {

/// What is exactly known of a column of the histories over a stretch of time: a curve, or a value, which is
/// a curve of two points.
struct ExactHistory {
  std::string column;
  std::string measure;  ///< that says so
  std::vector<double> time;
  std::vector<double> value;
};

/// What a job's measures are compared with, as far as it is a history or a value of one; the same curve of a
/// column only once. `job` has its scene. A formula that cannot be read is left out, and standard error says so.
std::vector<ExactHistory> exact_histories(const v1::Job& job);

}  // namespace trajan::client
