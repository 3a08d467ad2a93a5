#pragma once

#include <string>

namespace trajan {

struct WorkOptions {
  std::string server;
  int threads = 1;
  std::string worker_id;       ///< given by the server that started this worker; empty: one's own
  double grace_seconds = 300;  ///< so long a worker goes on without a server
  std::string log_level = "info";
};

/// Runs jobs one after another until SIGTERM or SIGINT (the job is given back), until the server says
/// that it does not want this worker, or until the server is away for too long. Returns the exit code.
int work(const WorkOptions& options);

}  // namespace trajan
