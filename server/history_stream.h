#pragma once

#include <filesystem>

#include "server/hub.h"
#include "server/store.h"
#include "server/stream.h"
#include "server/task_queue.h"
#include "trajan/v1/jobs.pb.h"

namespace trajan {

/// Rows of histories from the result file, of a job that runs or of one that ended. `queue` does the
/// reading; one thread is enough, as the file library works for one at a time.
grpc::ServerWriteReactor<v1::StreamHistoryResponse>* stream_history(grpc::CallbackServerContext* context,
                                                                    const v1::StreamHistoryRequest& request,
                                                                    store::Store& store, Hub& hub,
                                                                    TaskQueue& queue,
                                                                    const std::filesystem::path& jobs_directory);

}  // namespace trajan
