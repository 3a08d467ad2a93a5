#include "server/schedule.h"

#include <google/protobuf/text_format.h>

#include <algorithm>

#include "server/errors.h"
#include "server/log.h"
#include "server/store_jobs.h"

namespace trajan {

namespace {

Scheduler::Clock::duration seconds(double count) {
  return std::chrono::duration_cast<Scheduler::Clock::duration>(std::chrono::duration<double>(count));
}

}  // namespace

Scheduler::Scheduler(ScheduleOptions options, store::Store& store, Hub& hub, WorkerPool& pool,
                     std::function<void(std::int64_t)> study_changed)
    : options_(std::move(options)),
      store_(store),
      hub_(hub),
      pool_(pool),
      study_changed_(std::move(study_changed)) {}

void Scheduler::recover() {
  for (const store::Lease& lease : store_.read(store::leases)) {
    const bool local = lease.process_id != 0;
    if (local && !pool_.adopt(lease.worker, static_cast<pid_t>(lease.process_id))) {
      store_.commit([&](store::Database& database) {
        store::take_back(database, lease, "the worker ended while the server was away");
      });
      continue;
    }
    logging::info("lease taken over", {{"job", std::to_string(lease.job)}, {"worker", lease.worker}});
    const std::lock_guard lock(mutex_);
    activate(lease, Clock::now());
  }
}

void Scheduler::activate(const store::Lease& lease, Clock::time_point now) {
  Active active{lease, now + seconds(options_.lease_seconds)};
  if (lease.cancelling) active.kill_at = now + seconds(options_.cancel_grace_seconds);
  active_[store::lease_id(lease)] = active;
}

std::exception_ptr Scheduler::why_refused(const v1::LeaseRequest& request) const {
  if (draining_) {
    return std::make_exception_ptr(
        ServiceError(grpc::StatusCode::FAILED_PRECONDITION, "DRAINING", "the server is draining"));
  }
  if (request.process_id() != 0 && !pool_.owns(request.worker_id())) {
    return std::make_exception_ptr(ServiceError(grpc::StatusCode::FAILED_PRECONDITION, "UNKNOWN_WORKER",
                                                "this worker belongs to an earlier server"));
  }
  return nullptr;
}

void Scheduler::lease(const v1::LeaseRequest& request, std::function<bool()> gone, LeaseReply reply) {
  std::unique_lock lock(mutex_);
  if (const auto refused = why_refused(request)) {
    lock.unlock();
    reply({}, refused);
    return;
  }
  waiting_.push_back({request, std::move(gone), std::move(reply), Clock::now() + seconds(options_.poll_seconds)});
  request_assignment(std::move(lock));
}

void Scheduler::assign() { request_assignment(std::unique_lock(mutex_)); }

/// One assignment is under way at most, so that a job that is queued meanwhile is seen by the next.
void Scheduler::request_assignment(std::unique_lock<std::mutex> lock) {
  if (assigning_ || waiting_.empty() || draining_) {
    assign_again_ = assigning_;
    return;
  }
  assigning_ = true;
  assign_again_ = false;
  auto waiting = std::make_shared<Waiting>(std::move(waiting_.front()));
  waiting_.pop_front();
  lock.unlock();
  auto lease = std::make_shared<std::optional<store::Lease>>();
  store_.commit(
      [waiting, lease](store::Database& database) {
        if (waiting->gone()) return;
        *lease = store::lease_next(database, waiting->request.worker_id(), waiting->request.process_id());
      },
      [this, waiting, lease](std::exception_ptr error) {
        finish_assignment(std::move(*waiting), std::move(*lease), error);
      });
}

void Scheduler::finish_assignment(Waiting waiting, std::optional<store::Lease> lease, std::exception_ptr error) {
  std::unique_lock lock(mutex_);
  assigning_ = false;
  const bool again = lease.has_value() || assign_again_;
  if (lease && !error) {
    activate(*lease, Clock::now());
    lock.unlock();
    logging::info("job leased", {{"job", std::to_string(lease->job)},
                                 {"attempt", std::to_string(lease->attempt)},
                                 {"worker", lease->worker}});
    publish(*lease);
    reply_with(*lease, waiting.reply);
    // The worker may have died before its lease was known here.
    if (lease->process_id != 0 && !pool_.owns(lease->worker)) lose(*lease, "it ended before it began");
    lock.lock();
  } else if (error || waiting.gone()) {
    lock.unlock();
    waiting.reply({}, error);
    lock.lock();
  } else {
    waiting_.push_front(std::move(waiting));
  }
  if (again) request_assignment(std::move(lock));
}

void Scheduler::publish(const store::Lease& lease) {
  hub_.publish(lease.job);
  if (lease.study == 0) return;
  hub_.publish(lease.study);
  study_changed_(lease.study);
}

/// A worker that gets an error asks again, and gets the same lease.
void Scheduler::reply_with(const store::Lease& lease, const LeaseReply& reply) {
  try {
    reply(make_response(lease), nullptr);
  } catch (const std::exception&) {
    reply({}, std::current_exception());
  }
}

v1::LeaseResponse Scheduler::make_response(const store::Lease& lease) {
  v1::LeaseResponse response;
  response.set_lease_id(store::lease_id(lease));
  response.set_job_id(std::to_string(lease.job));
  *response.mutable_scene() =
      store_.read([&](store::Database& database) { return store::get_scene(database, lease.job); });
  google::protobuf::TextFormat::PrintToString(response.scene(), response.mutable_scene_text());
  const auto directory = options_.jobs_directory / response.job_id();
  std::filesystem::create_directories(directory);
  response.set_directory(directory.string());
  response.set_attempt(lease.attempt);
  response.set_duration_seconds(options_.lease_seconds);
  response.set_checkpoint_interval_seconds(options_.checkpoint_seconds);
  return response;
}

void Scheduler::report(const v1::ReportRequest& request, ReportReply reply) {
  v1::ReportResponse response;
  store::Lease lease;
  {
    const std::lock_guard lock(mutex_);
    const auto found = active_.find(request.lease_id());
    if (found != active_.end()) {
      found->second.deadline = Clock::now() + seconds(options_.lease_seconds);
      response.set_cancel(found->second.lease.cancelling);
      response.set_release(draining_);
      lease = found->second.lease;
    }
  }
  store_.commit([request](store::Database& database) { store::record_report(database, request); },
                [this, lease, response, reply = std::move(reply)](std::exception_ptr error) {
                  if (!error) publish(lease);
                  reply(response, error);
                });
}

void Scheduler::complete(const v1::CompleteRequest& request, CompleteReply reply) {
  store_.commit([request](store::Database& database) { store::complete(database, request); },
                [this, id = request.lease_id(), outcome = request.outcome_case(),
                 reply = std::move(reply)](std::exception_ptr error) {
                  std::unique_lock lock(mutex_);
                  const auto found = active_.find(id);
                  const store::Lease lease = found == active_.end() ? store::Lease{} : found->second.lease;
                  if (!error && found != active_.end()) active_.erase(found);
                  lock.unlock();
                  if (!error && lease.job != 0) {
                    logging::info("lease completed",
                                  {{"job", std::to_string(lease.job)}, {"outcome", std::to_string(outcome)}});
                    publish(lease);
                  }
                  reply(error);
                  assign();
                });
}

void Scheduler::cancel(std::int64_t job) {
  const std::lock_guard lock(mutex_);
  for (auto& [id, active] : active_) {
    if (active.lease.job != job || active.lease.cancelling) continue;
    active.lease.cancelling = true;
    active.kill_at = Clock::now() + seconds(options_.cancel_grace_seconds);
  }
}

void Scheduler::worker_lost(const std::string& worker, const std::string& how) {
  std::vector<store::Lease> lost;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [id, active] : active_) {
      if (active.lease.worker == worker) lost.push_back(active.lease);
    }
  }
  for (const store::Lease& lease : lost) lose(lease, how);
}

void Scheduler::lose(const store::Lease& lease, const std::string& how) {
  {
    const std::lock_guard lock(mutex_);
    active_.erase(store::lease_id(lease));
  }
  logging::warning("lease lost", {{"job", std::to_string(lease.job)}, {"worker", lease.worker}, {"how", how}});
  store_.commit([lease, how, most = options_.most_losses](
                    store::Database& database) { store::lose(database, lease, how, most); },
                [this, lease](std::exception_ptr) {
                  publish(lease);
                  assign();
                });
}

void Scheduler::tick(Clock::time_point now) {
  std::vector<store::Lease> overdue;
  std::vector<Waiting> answered;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [id, active] : active_) {
      if (now > active.deadline || now > active.kill_at) overdue.push_back(active.lease);
    }
    for (auto waiting = waiting_.begin(); waiting != waiting_.end();) {
      const bool over = draining_ || now > waiting->until || waiting->gone();
      if (over) answered.push_back(std::move(*waiting));
      waiting = over ? waiting_.erase(waiting) : waiting + 1;
    }
  }
  for (Waiting& waiting : answered) waiting.reply({}, nullptr);
  for (const store::Lease& lease : overdue) {
    // A local worker must be dead before another one may write the same files; its end is noticed.
    if (pool_.owns(lease.worker)) {
      pool_.kill(lease.worker);
    } else {
      lose(lease, "no report for too long");
    }
  }
}

void Scheduler::drain() {
  const std::lock_guard lock(mutex_);
  draining_ = true;
}

std::size_t Scheduler::active() const {
  const std::lock_guard lock(mutex_);
  return active_.size();
}

}  // namespace trajan
