#include "client/subprocess.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <sstream>

#include "client/exit_code.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

bool is_program(const fs::path& path) { return access(path.c_str(), X_OK) == 0 && !fs::is_directory(path); }

/// Runs between fork and exec: only async-signal-safe calls.
[[noreturn]] void become(const char* program, char* const* arguments, int log, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(127);  // it died before the line above
  setpgid(0, 0);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (log >= 0) {
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
  }
  execv(program, arguments);
  _exit(127);
}

int exit_status(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
  const char* search_path = std::getenv("PATH");
  std::istringstream folders(search_path == nullptr ? "/usr/bin:/bin" : search_path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (const fs::path path = fs::path(folder) / name; is_program(path)) return path;
  }
  return std::nullopt;
}

fs::path find_trajand() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (const fs::path beside = self.parent_path() / "trajand"; !error && is_program(beside)) return beside;
  if (const auto program = find_program("trajand")) return *program;
  throw CommandError(ExitCode::local_failure, "the server program trajand is missing",
                     "install it beside trajan, or name a running server with --server");
}

ChildProcess::ChildProcess(const fs::path& program, const std::vector<std::string>& arguments,
                           const fs::path& log) {
  std::vector<char*> pointers{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  int log_file = -1;
  if (!log.empty()) log_file = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  const pid_t parent = getpid();
  id_ = fork();
  if (id_ == 0) become(program.c_str(), pointers.data(), log_file, parent);
  const int reason = errno;
  if (log_file >= 0) close(log_file);
  if (id_ < 0) {
    throw CommandError(ExitCode::local_failure, "cannot start " + program.string() + ": " + std::strerror(reason));
  }
}

ChildProcess::~ChildProcess() {
  terminate();
  wait();
}

int ChildProcess::wait() {
  int status = 0;
  while (!status_) {
    const pid_t ended = waitpid(id_, &status, 0);
    if (ended == id_) status_ = exit_status(status);
    if (ended < 0 && errno != EINTR) status_ = 127;
  }
  return *status_;
}

bool ChildProcess::has_ended() {
  int status = 0;
  if (!status_ && waitpid(id_, &status, WNOHANG) == id_) status_ = exit_status(status);
  return status_.has_value();
}

void ChildProcess::terminate() {
  if (!has_ended()) kill(id_, SIGTERM);
}

}  // namespace trajan::client
