#pragma once

#include <memory>

#include "server/hub.h"
#include "server/store.h"
#include "server/stream.h"
#include "server/task_queue.h"
#include "trajan/v1/jobs.pb.h"

namespace trajan {

/// The state of a job, then its events after `request.after_sequence()` until it ends.
grpc::ServerWriteReactor<v1::WatchJobResponse>* watch_job(grpc::CallbackServerContext* context,
                                                          const v1::WatchJobRequest& request, store::Store& store,
                                                          Hub& hub, TaskQueue& queue);

}  // namespace trajan
