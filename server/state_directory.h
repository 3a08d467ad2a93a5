#pragma once

#include <filesystem>

namespace trajan {

/// The directory in which a server keeps everything; private to its user, and to one server at a time.
class StateDirectory {
 public:
  /// Creates it if it is not there. Throws std::runtime_error if that fails or another server has it.
  explicit StateDirectory(std::filesystem::path path);
  ~StateDirectory();
  StateDirectory(const StateDirectory&) = delete;
  StateDirectory& operator=(const StateDirectory&) = delete;

  std::filesystem::path database() const { return path_ / "queue.sqlite"; }
  std::filesystem::path jobs() const { return path_ / "jobs"; }
  std::filesystem::path measuring() const { return path_ / "measuring"; }

 private:
  const std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace trajan
