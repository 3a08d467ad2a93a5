#include "solver/results/durable.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace trajan::results {

namespace {

[[noreturn]] void fail_with_errno(const std::string& what) {
  throw std::runtime_error("cannot " + what + ": " + std::strerror(errno));
}

}  // namespace

void synchronize(int file_descriptor) {
  if (fsync(file_descriptor) != 0) fail_with_errno("make the file durable");
}

void synchronize(const std::filesystem::path& file_or_directory) {
  const int descriptor = open(file_or_directory.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail_with_errno("open " + file_or_directory.string());
  const bool done = fsync(descriptor) == 0;
  const int reason = errno;
  close(descriptor);
  errno = reason;
  if (!done) fail_with_errno("make " + file_or_directory.string() + " durable");
}

void publish(const std::filesystem::path& from, const std::filesystem::path& to) {
  synchronize(from);
  if (rename(from.c_str(), to.c_str()) != 0) fail_with_errno("rename " + from.string() + " to " + to.string());
  synchronize(to.parent_path());
}

void divert_to_memory(int file_descriptor) {
  const int memory = memfd_create("discarded", MFD_CLOEXEC);
  if (memory < 0) return;
  dup3(memory, file_descriptor, O_CLOEXEC);
  close(memory);
}

DirectoryLock::DirectoryLock(const std::filesystem::path& directory)
    : descriptor_(open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0) fail_with_errno("open " + directory.string());
  // Some network file systems cannot lock directories; there the scheduler's leases must do.
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(descriptor_);
    throw std::runtime_error("cannot write to " + directory.string() + ": another process writes there");
  }
}

DirectoryLock::~DirectoryLock() { close(descriptor_); }

}  // namespace trajan::results
