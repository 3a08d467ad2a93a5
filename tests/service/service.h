#pragma once

#include <grpcpp/channel.h>
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "trajan/v1/jobs.grpc.pb.h"
#include "trajan/v1/studies.grpc.pb.h"

/// Real server processes in temporary directories, for tests that see them as any client does.
namespace trajan::test {

class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A `trajand` process.
class Process {
 public:
  /// Starts it with these arguments.
  explicit Process(const std::vector<std::string>& arguments);
  /// Ends it by force if it lives.
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t id() const { return id_; }
  void send(int signal) const;
  /// Waits for its end; the exit code, or minus the signal that killed it.
  int wait();
  /// The next line on its stdout; empty at the end.
  std::string read_line();

 private:
  pid_t id_ = 0;
  int output_ = -1;
  bool ended_ = false;
  int result_ = 0;
};

inline const std::vector<std::string> frequent_checkpoints = {"--checkpoint-interval", "0.2", "--lease", "5"};

/// A server on a state directory of its own, and a client of it. Ends all of its workers with it.
class Service {
 public:
  explicit Service(std::vector<std::string> options = {});
  ~Service();

  /// Starts the server again on the same state, after `server().wait()`.
  void restart();
  Process& server() { return *server_; }
  v1::Jobs::Stub& jobs() { return *jobs_; }
  const std::shared_ptr<grpc::Channel>& channel() const { return channel_; }
  const std::filesystem::path& state() const { return directory_.path(); }
  std::filesystem::path job_directory(const std::string& job) const { return state() / "jobs" / job; }

  /// The workers that live, also those of a server that was killed.
  std::vector<pid_t> workers() const;

  std::string submit(const v1::Scene& scene);
  /// A sweep of a scene that ends after these shares of its time.
  std::string sweep(const v1::Scene& scene, const std::vector<double>& shares);
  v1::Study study(const std::string& job);
  v1::Job get(const std::string& job);
  /// Follows a job until `enough` says so or the stream ends, whose status is returned. Events are
  /// appended to `events`, and the last job message is put into `last`.
  grpc::Status watch(const std::string& job, std::vector<v1::Event>& events, v1::Job& last,
                     const std::function<bool(const v1::WatchJobResponse&)>& enough = nullptr);
  /// Follows a job to its end, across restarts of the server.
  v1::Job wait(const std::string& job);
  /// Follows a running job until its solver has written a checkpoint.
  void wait_for_checkpoint(const std::string& job);
  /// All rows of all columns; row-major.
  std::vector<double> history(const std::string& job, bool follow);

 private:
  TemporaryDirectory directory_;
  std::vector<std::string> options_;
  std::unique_ptr<Process> server_;
  std::shared_ptr<grpc::Channel> channel_;
  std::unique_ptr<v1::Jobs::Stub> jobs_;
  std::unique_ptr<v1::Studies::Stub> studies_;
};

/// How many times slower a sanitizer makes computing, about: runs that shall last some seconds are shorter by it.
double slowness();

/// The vibration of a short bar: some seconds of computing for a `length` of 1, also under a sanitizer.
v1::Scene bar(double length = 1, int samples = 2000);

/// Waits until `condition` holds; false if it does not within a time that is much too long.
bool eventually(const std::function<bool()>& condition);

/// The typed details of a failed call.
v1::ErrorDetails details(const grpc::ClientContext& context);

}  // namespace trajan::test
