#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trajan::client {

/// A program of the search path, or nothing.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// `trajand`, beside this program or on the search path. Throws CommandError if it is missing.
std::filesystem::path find_trajand();

/// A program that was started without a shell. It gets SIGTERM if this process dies.
class ChildProcess {
 public:
  /// `log`: where its standard output and error go; empty: where ours go. Signals from the terminal do not
  /// reach it. Throws CommandError.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::filesystem::path& log);
  /// Asks it to end, and waits until it has.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits for its end: the exit status, or 128 and the number of the signal that ended it.
  int wait();
  bool has_ended();
  void terminate();

 private:
  pid_t id_ = -1;
  std::optional<int> status_;
};

}  // namespace trajan::client
