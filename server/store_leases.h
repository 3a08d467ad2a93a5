#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/store_database.h"
#include "trajan/v1/worker.pb.h"

/// Who computes what. A lease is one attempt of one job by one worker; it is a part of the job's row, so
/// that it survives a restart of the server. What changes something must run inside Store::commit.
namespace trajan::store {

struct Lease {
  std::int64_t job = 0;
  int attempt = 0;
  std::string worker;
  std::int64_t process_id = 0;  ///< 0 if the worker is not one of the server's own
  bool cancelling = false;
  std::int64_t study = 0;  ///< that it is a run of, or 0
};

/// "12-3" for the third attempt of job 12.
std::string lease_id(const Lease& lease);

/// All present leases.
std::vector<Lease> leases(Database& database);

/// Gives the worker the next job: highest priority, then first submitted; but no run of a study while an equal
/// scene is computed, whose answer it may take over. A worker that holds a lease (its answer was lost) gets the
/// same again. Empty if no job waits.
std::optional<Lease> lease_next(Database& database, const std::string& worker, std::int64_t process_id);

// The following throw ServiceError NOT_FOUND if the lease is not a present one.

/// Appends progress and new warnings to the job and its events.
void record_report(Database& database, const v1::ReportRequest& report);

/// Ends the lease with what the worker says. Again for an attempt that ended its job: no effect.
void complete(Database& database, const v1::CompleteRequest& request);

/// The worker ended for reasons that are not the job's: the job waits again. No effect if the lease is
/// not a present one.
void take_back(Database& database, const Lease& lease, const std::string& why);

/// The worker is gone: the job waits again, or, after `most_losses` losses, fails as WORKER_LOST. No
/// effect if the lease is not a present one.
void lose(Database& database, const Lease& lease, const std::string& how, int most_losses);

}  // namespace trajan::store
