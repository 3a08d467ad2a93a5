#pragma once

#include <chrono>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "server/hub.h"
#include "server/pool.h"
#include "server/store.h"
#include "server/store_leases.h"

namespace trajan {

struct ScheduleOptions {
  std::filesystem::path jobs_directory;
  double lease_seconds = 30;
  double checkpoint_seconds = 10;
  double cancel_grace_seconds = 10;
  double poll_seconds = 5;  ///< a worker's request waits so long for a job
  int most_losses = 3;      ///< a job that lost so many workers fails
};

/// Gives queued jobs to workers that ask, keeps the leases' clocks, and takes jobs back from workers
/// that are lost. What must survive is in the store; here are only clocks and waiting requests. Any
/// thread may call; replies come from the store's writer thread or from the caller's.
class Scheduler {
 public:
  using Clock = std::chrono::steady_clock;
  /// No lease: there was no job, or an error tells the worker to go away.
  using LeaseReply = std::function<void(const v1::LeaseResponse&, std::exception_ptr)>;
  using ReportReply = std::function<void(const v1::ReportResponse&, std::exception_ptr)>;
  using CompleteReply = std::function<void(std::exception_ptr)>;

  /// `study_changed` is called with the number of the study whose run changed, and returns at once.
  Scheduler(ScheduleOptions options, store::Store& store, Hub& hub, WorkerPool& pool,
            std::function<void(std::int64_t)> study_changed);

  /// Takes over the leases of an earlier server: their clocks start again, and jobs whose local worker
  /// died meanwhile are lost at once. Call first.
  void recover();

  /// `gone` says that nobody waits for the reply any more.
  void lease(const v1::LeaseRequest& request, std::function<bool()> gone, LeaseReply reply);
  void report(const v1::ReportRequest& request, ReportReply reply);
  void complete(const v1::CompleteRequest& request, CompleteReply reply);

  /// Something was queued.
  void assign();
  /// The store says that the job is CANCELLING: its worker is told, and ended by force if it does not
  /// follow within the grace period.
  void cancel(std::int64_t job);
  void worker_lost(const std::string& worker, const std::string& how);
  /// Looks at the clocks; call several times a second.
  void tick(Clock::time_point now);

  /// Gives out no more leases and asks all workers for theirs.
  void drain();
  std::size_t active() const;

 private:
  struct Waiting {
    v1::LeaseRequest request;
    std::function<bool()> gone;
    LeaseReply reply;
    Clock::time_point until;
  };
  struct Active {
    store::Lease lease;
    Clock::time_point deadline;
    Clock::time_point kill_at = Clock::time_point::max();
  };
  void request_assignment(std::unique_lock<std::mutex> lock);
  void finish_assignment(Waiting waiting, std::optional<store::Lease> lease, std::exception_ptr error);
  void activate(const store::Lease& lease, Clock::time_point now);
  /// The job changed, and so did the study that it is a run of.
  void publish(const store::Lease& lease);
  void reply_with(const store::Lease& lease, const LeaseReply& reply);
  v1::LeaseResponse make_response(const store::Lease& lease);
  void lose(const store::Lease& lease, const std::string& how);
  std::exception_ptr why_refused(const v1::LeaseRequest& request) const;

  const ScheduleOptions options_;
  store::Store& store_;
  Hub& hub_;
  WorkerPool& pool_;
  const std::function<void(std::int64_t)> study_changed_;
  mutable std::mutex mutex_;
  std::deque<Waiting> waiting_;
  std::map<std::string, Active> active_;  ///< by lease id
  bool assigning_ = false;
  bool assign_again_ = false;
  bool draining_ = false;
};

}  // namespace trajan
