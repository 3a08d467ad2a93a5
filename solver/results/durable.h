#pragma once

#include <filesystem>

namespace trajan::results {

/// Waits until what was written is on the disk. Throws std::runtime_error.
void synchronize(int file_descriptor);
void synchronize(const std::filesystem::path& file_or_directory);

/// Makes `from` durable, gives it the name `to` at once (replacing a file of that name) and makes the
/// name durable too. Both lie in the same directory.
void publish(const std::filesystem::path& from, const std::filesystem::path& to);

/// Lets later writes through this descriptor go to memory that vanishes with it: the file stays as it is
/// although its library still wants to close it.
void divert_to_memory(int file_descriptor);

/// Keeps a second writer out of a directory, also one in another process, until destroyed or killed.
class DirectoryLock {
 public:
  /// Throws std::runtime_error if another writer holds it.
  explicit DirectoryLock(const std::filesystem::path& directory);
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;
  ~DirectoryLock();

 private:
  int descriptor_;
};

}  // namespace trajan::results
