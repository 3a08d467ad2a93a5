#include "server/measurer.h"

#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>

#include "server/log.h"
#include "server/measure.h"
#include "server/spawn.h"

namespace trajan {

namespace {

class WorkingDirectory {
 public:
  explicit WorkingDirectory(const std::filesystem::path& parent) {
    std::filesystem::create_directories(parent);
    std::string name = (parent / "measure-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
    path_ = name;
  }
  ~WorkingDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::optional<std::string> read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

Measurer::Measurer(std::filesystem::path directory) : directory_(std::move(directory)) {
  // What an earlier server left behind.
  std::error_code ignored;
  std::filesystem::remove_all(directory_, ignored);
}

std::optional<v1::Calibration> Measurer::calibrate() {
  v1::Calibration calibration;
  const auto answer = run({"calibrate"}, "");
  if (!answer || !calibration.ParseFromString(*answer)) return std::nullopt;
  return calibration;
}

std::optional<v1::Trial> Measurer::try_scene(const v1::Scene& scene, double seconds, int threads) {
  v1::Trial trial;
  const auto answer = run({"try", "--seconds", std::to_string(seconds), "--threads", std::to_string(threads)},
                          scene.SerializeAsString());
  if (!answer || !trial.ParseFromString(*answer)) return std::nullopt;
  return trial;
}

std::optional<std::string> Measurer::run(std::vector<std::string> command, const std::string& input) {
  try {
    const WorkingDirectory directory(directory_);
    std::ofstream(directory.path() / measuring::question_file, std::ios::binary) << input;
    command.insert(command.begin(), "/proc/self/exe");
    command.push_back(directory.path().string());
    pid_t process = 0;
    {
      const std::lock_guard lock(mutex_);
      if (stopped_) return std::nullopt;
      process = spawn(command);
      running_.insert(process);
    }
    int status = 0;
    while (!has_ended(process, status)) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (status == 0) return read_file(directory.path() / measuring::answer_file);
    logging::warning("measuring failed", {{"command", command[1]}, {"status", std::to_string(status)}});
  } catch (const std::exception& error) {
    logging::warning("measuring failed", {{"command", command[0]}, {"error", error.what()}});
  }
  return std::nullopt;
}

bool Measurer::has_ended(pid_t process, int& status) {
  const std::lock_guard lock(mutex_);
  if (waitpid(process, &status, WNOHANG) == 0) return false;
  running_.erase(process);
  return true;
}

void Measurer::stop() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  for (const pid_t process : running_) kill(process, SIGKILL);
}

}  // namespace trajan
