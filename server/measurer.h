#pragma once

#include <sys/types.h>

#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "trajan/v1/estimates.pb.h"

namespace trajan {

/// Has this program's measuring commands (server/measure.h) run as processes of their own, for the server computes
/// nothing. Any thread may call; calls wait for the process.
class Measurer {
 public:
  /// `directory`: for files that are there for a moment.
  explicit Measurer(std::filesystem::path directory);
  ~Measurer() { stop(); }

  /// Nothing if the process failed or was stopped; likewise below.
  std::optional<v1::Calibration> calibrate();
  std::optional<v1::Trial> try_scene(const v1::Scene& scene, double seconds, int threads);

  /// Ends the processes that run, and starts no more.
  void stop();

 private:
  /// Runs the command with a directory of its own as its last argument; what it has left in the file "answer".
  std::optional<std::string> run(std::vector<std::string> command, const std::string& input);
  bool has_ended(pid_t process, int& status);

  const std::filesystem::path directory_;
  std::mutex mutex_;
  std::set<pid_t> running_;
  bool stopped_ = false;
};

}  // namespace trajan
