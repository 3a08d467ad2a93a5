#include "server/run_cost.h"

#include <malloc.h>
#include <sys/resource.h>

#include <fstream>
#include <string>

namespace trajan {

namespace {

double processor_seconds() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// What comes after `key`, blanks and colons in a file of lines; empty if there is none.
std::string value_in(const char* file, const std::string& key) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t value = line.find_first_not_of(" \t:", key.size());
    return value == std::string::npos ? std::string() : line.substr(value);
  }
  return {};
}

/// Forgets the largest resident memory so far (proc(5)).
void reset_peak_memory() { std::ofstream("/proc/self/clear_refs") << 5; }

std::int64_t status_bytes(const std::string& key) {
  const std::string kibibytes = value_in("/proc/self/status", key);
  return std::strtoll(kibibytes.c_str(), nullptr, 10) * 1024;
}

/// What the process holds of its own once what was freed is given back.
std::int64_t own_bytes() {
  malloc_trim(0);
  return status_bytes("RssAnon");
}

}  // namespace

void give_back_freed_memory() {
  constexpr int least_bytes_of_a_mapping = 32 << 10;
  mallopt(M_MMAP_THRESHOLD, least_bytes_of_a_mapping);
  mallopt(M_ARENA_MAX, 1);
}

std::string machine_name() { return value_in("/proc/cpuinfo", "model name"); }

RunCost::RunCost(int threads)
    : threads_(threads),
      own_bytes_(own_bytes()),
      processor_seconds_(processor_seconds()),
      start_(std::chrono::steady_clock::now()) {
  reset_peak_memory();
}

v1::Cost RunCost::so_far() const {
  v1::Cost cost;
  cost.set_core_seconds(processor_seconds() - processor_seconds_);
  cost.set_wall_seconds(std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count());
  cost.set_threads(threads_);
  const std::int64_t peak = status_bytes("VmHWM");
  cost.set_peak_memory_bytes(peak);
  // Pages of files only grow in number, and belong to the program.
  cost.set_memory_bytes(peak - status_bytes("RssFile") - status_bytes("RssShmem") - own_bytes_);
  cost.set_machine(machine_name());
  return cost;
}

}  // namespace trajan
