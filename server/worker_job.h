#pragma once

#include <optional>

#include "server/lease_keeper.h"
#include "trajan/v1/worker.pb.h"

namespace trajan {

/// Computes a leased job in its directory: translate, validate, run, evaluate, write. Goes on from the
/// directory's checkpoint if there is one. Returns how it ended; empty if the lease was lost, in which
/// case nobody wants to know. Never throws.
std::optional<v1::CompleteRequest> run_job(const v1::LeaseResponse& lease, int threads, LeaseKeeper& keeper);

}  // namespace trajan
