#include "server/state_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <stdexcept>

namespace trajan {

StateDirectory::StateDirectory(std::filesystem::path path) : path_(std::move(path)) {
  umask(S_IRWXG | S_IRWXO);
  std::filesystem::create_directories(jobs());
  const std::filesystem::path file = path_ / "lock";
  lock_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (lock_ < 0) throw std::runtime_error("cannot write to the state directory " + path_.string());
  if (flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    close(lock_);
    throw std::runtime_error("another server uses the state directory " + path_.string());
  }
}

StateDirectory::~StateDirectory() { close(lock_); }

}  // namespace trajan
