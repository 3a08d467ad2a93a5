#include "server/pool.h"

#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>
#include <system_error>

#include "server/log.h"
#include "server/spawn.h"

namespace trajan {

namespace {

std::string make_worker_id() {
  std::random_device random;
  std::ostringstream id;
  id << "local-" << std::hex << random() << random();
  return id.str();
}

/// A process with this number may by now be any other program: only one that was given the worker's
/// unguessable name is ours.
bool is_worker(pid_t process, const std::string& worker) {
  std::ifstream file("/proc/" + std::to_string(process) + "/cmdline", std::ios::binary);
  // Reading fails softly if the process ends meanwhile.
  std::string command;
  std::getline(file, command, '\n');
  return command.find(worker) != std::string::npos;
}

std::string describe(int status, bool killed_by_us) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    std::string text = "killed by signal " + std::to_string(signal);
    if (signal == SIGKILL && killed_by_us) text += " for not answering";
    if (signal == SIGKILL && !killed_by_us) text += ", perhaps because memory ran out";
    return text;
  }
  return "exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

WorkerPool::WorkerPool(int size, Lost lost) : size_(size), lost_(std::move(lost)) {}

bool WorkerPool::adopt(const std::string& worker, pid_t process) {
  if (process <= 0 || !is_worker(process, worker)) return false;
  const std::lock_guard lock(mutex_);
  processes_[worker] = {process, false, false, Clock::now()};
  return true;
}

void WorkerPool::start(std::vector<std::string> command) {
  const std::lock_guard lock(mutex_);
  command_ = std::move(command);
}

void WorkerPool::tick(Clock::time_point now) {
  for (const Ended& ended : remove_ended(now)) {
    logging::info("worker ended", {{"worker", ended.worker}, {"how", ended.how}});
    lost_(ended.worker, ended.how);
  }
  const std::lock_guard lock(mutex_);
  if (!command_.empty()) start_missing(now);
}

std::vector<WorkerPool::Ended> WorkerPool::remove_ended(Clock::time_point now) {
  constexpr auto early = std::chrono::seconds(10);
  constexpr auto longest_pause = std::chrono::seconds(30);
  const std::lock_guard lock(mutex_);
  std::vector<Ended> ended;
  for (auto entry = processes_.begin(); entry != processes_.end();) {
    const auto& [worker, process] = *entry;
    int status = 0;
    const bool gone = process.child ? waitpid(process.id, &status, WNOHANG) != 0 : !is_worker(process.id, worker);
    if (!gone) {
      ++entry;
      continue;
    }
    early_ends_ = now - process.started < early ? std::min(early_ends_ + 1, 10) : 0;
    const std::string how = process.child ? describe(status, process.killed) : "it disappeared";
    ended.push_back({worker, how});
    entry = processes_.erase(entry);
  }
  // The first early end may be bad luck; a series is a worker that cannot live here.
  if (!ended.empty() && early_ends_ > 1) {
    next_start_ = now + std::min<Clock::duration>(std::chrono::milliseconds(50 << early_ends_), longest_pause);
  }
  return ended;
}

void WorkerPool::start_missing(Clock::time_point now) {
  while (std::ssize(processes_) < size_ && now >= next_start_) {
    const std::string worker = make_worker_id();
    std::vector<std::string> command = command_;
    command.insert(command.end(), {"--worker-id", worker});
    try {
      processes_[worker] = {spawn(command), true, false, now};
    } catch (const std::system_error& error) {
      logging::error("worker not started", {{"error", error.what()}});
      next_start_ = now + std::chrono::seconds(1);
      return;
    }
    logging::info("worker started", {{"worker", worker}});
  }
}

bool WorkerPool::owns(const std::string& worker) const {
  const std::lock_guard lock(mutex_);
  return processes_.contains(worker);
}

void WorkerPool::kill(const std::string& worker) {
  const std::lock_guard lock(mutex_);
  const auto found = processes_.find(worker);
  if (found == processes_.end()) return;
  found->second.killed = true;
  ::kill(found->second.id, SIGKILL);
}

void WorkerPool::stop(int signal) {
  const std::lock_guard lock(mutex_);
  command_.clear();
  for (const auto& [worker, process] : processes_) ::kill(process.id, signal);
}

std::size_t WorkerPool::alive() const {
  const std::lock_guard lock(mutex_);
  return processes_.size();
}

}  // namespace trajan
