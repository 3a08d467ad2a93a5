#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "solver/analyses/run.h"
#include "trajan/v1/worker.grpc.pb.h"

namespace trajan {

/// What the server, or a signal, wants of a running job.
enum class Command { go_on, cancel, release, lost };

/// Speaks with the server about one lease, in a thread of its own: the solver leaves its progress here
/// and never waits for the network. While the server is away it keeps trying; after `grace_seconds` it
/// commands a release.
class LeaseKeeper {
 public:
  /// `leaving` is set when the worker is to end; it commands a release.
  LeaseKeeper(v1::Workers::StubInterface& server, const v1::LeaseResponse& lease, double grace_seconds,
              const std::atomic<bool>& leaving);
  /// Stops speaking; waits for a report that is under way.
  ~LeaseKeeper();
  LeaseKeeper(const LeaseKeeper&) = delete;
  LeaseKeeper& operator=(const LeaseKeeper&) = delete;

  /// For the job and its event log. Waits for the server, but not for long: warnings are in the result's file too.
  void tell(const v1::Warning& warning);
  /// Takes the latest progress. True if the run shall stop.
  bool update(const RunProgress& progress);
  Command command() const;
  /// The latest progress with the remaining time.
  v1::Progress progress() const;

 private:
  using Clock = std::chrono::steady_clock;
  void speak();
  void report_once();
  grpc::Status report(const v1::ReportRequest& request, v1::ReportResponse& response) const;
  Clock::duration pause() const;

  v1::Workers::StubInterface& server_;
  const std::string lease_id_;
  const double lease_seconds_;
  const double grace_seconds_;
  const std::atomic<bool>& leaving_;
  const Clock::time_point started_ = Clock::now();
  Clock::time_point server_seen_ = started_;
  std::atomic<Command> command_ = Command::go_on;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<RunProgress> first_;
  std::optional<RunProgress> latest_;
  bool closed_ = false;
  std::thread thread_;
};

}  // namespace trajan
