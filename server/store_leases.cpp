#include "server/store_leases.h"

#include <algorithm>
#include <charconv>

#include "server/errors.h"
#include "server/store_answers.h"
#include "server/store_estimates.h"
#include "server/store_findings.h"
#include "server/store_jobs.h"

namespace trajan::store {

namespace {

struct LeaseNumbers {
  std::int64_t job = 0;
  int attempt = 0;
};

LeaseNumbers parse_lease_id(const std::string& id) {
  LeaseNumbers numbers;
  const char* end = id.data() + id.size();
  const auto dash = std::from_chars(id.data(), end, numbers.job).ptr;
  if (dash != end && *dash == '-') std::from_chars(dash + 1, end, numbers.attempt);
  return numbers;
}

[[noreturn]] void throw_lost(const std::string& id) {
  throw ServiceError(grpc::StatusCode::NOT_FOUND, "LEASE_LOST", "lease \"" + id + "\" is lost");
}

struct LeasedJob {
  v1::Job job;
  std::int64_t losses = 0;
};

std::optional<LeasedJob> find_leased(Database& database, LeaseNumbers lease) {
  Statement query = database.prepare("SELECT job, losses FROM jobs WHERE job_id = ? AND worker IS NOT NULL");
  if (!query.bind(1, lease.job).step()) return std::nullopt;
  LeasedJob found{{}, query.integer(1)};
  found.job.ParseFromString(query.text(0));
  if (found.job.attempts() != lease.attempt) return std::nullopt;
  return found;
}

Lease make_lease(const v1::Job& job, const std::string& worker, std::int64_t process_id) {
  const std::int64_t study = job.parent_id().empty() ? 0 : job_number(job.parent_id());
  const bool cancelling = job.state() == v1::CANCELLING;
  return {job_number(job.job_id()), job.attempts(), worker, process_id, cancelling, study};
}

Lease read_lease(Statement& query) {
  v1::Job job;
  job.ParseFromString(query.text(1));
  return make_lease(job, query.text(2), query.integer(3));
}

void release_worker(Database& database, std::int64_t job) {
  database.prepare("UPDATE jobs SET worker = NULL, process_id = 0 WHERE job_id = ?").bind(1, job).run();
}

void fail(Database& database, v1::Job& job, const v1::Failure& failure) {
  *job.mutable_failure() = failure;
  enter(database, job, v1::FAILED);
}

/// The job is not computed any more, but not at its end.
void wait_again(Database& database, v1::Job& job, const std::string& why) {
  const bool cancelling = job.state() == v1::CANCELLING;
  append_message(database, job, why + (cancelling ? "" : "; goes on from its last checkpoint, if there is one"));
  enter(database, job, cancelling ? v1::CANCELLED : v1::QUEUED);
}

void add_cost(v1::Job& job, const v1::Cost& cost) {
  const v1::Cost before = job.cost();
  *job.mutable_cost() = cost;
  job.mutable_cost()->set_core_seconds(before.core_seconds() + cost.core_seconds());
  job.mutable_cost()->set_wall_seconds(before.wall_seconds() + cost.wall_seconds());
  job.mutable_cost()->set_peak_memory_bytes(std::max(before.peak_memory_bytes(), cost.peak_memory_bytes()));
  job.mutable_cost()->set_memory_bytes(std::max(before.memory_bytes(), cost.memory_bytes()));
}

void apply_outcome(Database& database, v1::Job& job, const v1::CompleteRequest& request) {
  if (request.has_progress()) {
    *job.mutable_progress() = request.progress();
    v1::Event event;
    *event.mutable_progress() = request.progress();
    append_event(database, job, std::move(event));
  }
  if (request.has_result()) *job.mutable_result() = request.result();
  if (request.has_cost()) add_cost(job, request.cost());
  add_warnings(database, job, request.warnings());
  switch (request.outcome_case()) {
    case v1::CompleteRequest::kSucceeded:
      *job.mutable_measures() = request.succeeded().measures();
      enter(database, job, v1::SUCCEEDED);
      break;
    case v1::CompleteRequest::kFailed:
      fail(database, job, request.failed());
      break;
    case v1::CompleteRequest::kCancelled:
      enter(database, job, v1::CANCELLED);
      break;
    case v1::CompleteRequest::kReleased:
      wait_again(database, job, "released by its worker");
      break;
    case v1::CompleteRequest::OUTCOME_NOT_SET:
      throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "NO_OUTCOME", "the outcome is not set");
  }
}

}  // namespace

std::string lease_id(const Lease& lease) {
  return std::to_string(lease.job) + "-" + std::to_string(lease.attempt);
}

std::vector<Lease> leases(Database& database) {
  Statement query = database.prepare("SELECT job_id, job, worker, process_id FROM jobs WHERE worker IS NOT NULL");
  std::vector<Lease> found;
  while (query.step()) found.push_back(read_lease(query));
  return found;
}

std::optional<Lease> lease_next(Database& database, const std::string& worker, std::int64_t process_id) {
  {
    Statement held = database.prepare("SELECT job_id, job, worker, process_id FROM jobs WHERE worker = ?");
    if (held.bind(1, worker).step()) return read_lease(held);
  }
  std::int64_t number = 0;
  {
    Statement next = database.prepare(
        "SELECT job_id FROM jobs AS waiting WHERE state = 1 AND is_study = 0 AND NOT (reuse AND EXISTS "
        "(SELECT 1 FROM jobs AS equal WHERE equal.scene = waiting.scene AND equal.state IN (2, 3))) "
        "ORDER BY priority DESC, job_id LIMIT 1");
    if (!next.step()) return std::nullopt;
    number = next.integer(0);
  }
  v1::Job job = get_job(database, number);
  job.set_attempts(job.attempts() + 1);
  enter(database, job, v1::RUNNING);
  update(database, job);
  Statement take = database.prepare("UPDATE jobs SET worker = ?, process_id = ? WHERE job_id = ?");
  take.bind(1, worker).bind(2, process_id).bind(3, number).run();
  return make_lease(job, worker, process_id);
}

void record_report(Database& database, const v1::ReportRequest& report) {
  auto leased = find_leased(database, parse_lease_id(report.lease_id()));
  if (!leased) throw_lost(report.lease_id());
  if (report.has_progress()) {
    *leased->job.mutable_progress() = report.progress();
    v1::Event event;
    *event.mutable_progress() = report.progress();
    append_event(database, leased->job, std::move(event));
  }
  add_warnings(database, leased->job, report.warnings());
  update(database, leased->job);
}

void complete(Database& database, const v1::CompleteRequest& request) {
  const LeaseNumbers numbers = parse_lease_id(request.lease_id());
  auto leased = find_leased(database, numbers);
  if (!leased) {
    if (!exists(database, numbers.job)) throw_lost(request.lease_id());
    const v1::Job job = get_job(database, numbers.job);
    if (has_ended(job.state()) && job.attempts() == numbers.attempt) return;
    throw_lost(request.lease_id());
  }
  apply_outcome(database, leased->job, request);
  const bool succeeded = leased->job.state() == v1::SUCCEEDED;
  if (succeeded) {
    keep_findings(database, leased->job);
    keep_actual(database, leased->job);
  }
  update(database, leased->job);
  release_worker(database, numbers.job);
  if (succeeded) answer_equal_scenes(database, leased->job);
}

void take_back(Database& database, const Lease& lease, const std::string& why) {
  auto leased = find_leased(database, {lease.job, lease.attempt});
  if (!leased) return;
  wait_again(database, leased->job, why);
  update(database, leased->job);
  release_worker(database, lease.job);
}

void lose(Database& database, const Lease& lease, const std::string& how, int most_losses) {
  auto leased = find_leased(database, {lease.job, lease.attempt});
  if (!leased) return;
  v1::Job& job = leased->job;
  const std::int64_t losses = leased->losses + 1;
  if (losses < most_losses || job.state() == v1::CANCELLING) {
    wait_again(database, job, "worker lost (" + how + ")");
  } else {
    v1::Failure failure;
    failure.set_reason("WORKER_LOST");
    failure.set_message(std::to_string(losses) + " workers were lost with this job, the last one: " + how);
    failure.set_remedy("the job may need more memory than there is, or crash the solver: report it");
    failure.set_particle(-1);
    fail(database, job, failure);
  }
  update(database, job);
  release_worker(database, lease.job);
  database.prepare("UPDATE jobs SET losses = ? WHERE job_id = ?").bind(1, losses).bind(2, lease.job).run();
}

}  // namespace trajan::store
