#pragma once

#include <optional>
#include <span>
#include <string>

#include "client/table.h"
#include "trajan/v1/jobs.pb.h"

namespace trajan::client {

/// One row for each job: what `trajan ls` shows.
Table job_table(std::span<const v1::Job* const> jobs);

/// All about one job but its measures, a fact on each line: what `trajan show` begins with.
std::string describe_job(const v1::Job& job, const std::string& expectation = {});

/// Why a job failed and, if it stopped in mid-run, where: "DIVERGED: ... (step 10, time 0.5, particle 3)".
std::string failure_text(const v1::Failure& failure);

/// One row for each measure: value, exact value, error, expected tolerance and verdict: "ok" within the
/// tolerance, "off" outside, nothing if there is no tolerance.
Table measure_table(const v1::Job& job);

/// "2026-03-01 12:30:05" in local time; nothing if the time is not set.
std::optional<std::string> time_text(const google::protobuf::Timestamp& time);

/// The message as JSON with the field names of the schema.
std::string json_text(const google::protobuf::Message& message, bool on_one_line);

}  // namespace trajan::client
