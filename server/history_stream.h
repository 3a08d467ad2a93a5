#pragma once

#include <filesystem>

#include "server/history_readers.h"
#include "server/hub.h"
#include "server/store.h"
#include "server/stream.h"
#include "server/task_queue.h"
#include "trajan/v1/jobs.pb.h"

namespace trajan {

/// The thread that reads histories, and the files that it has open. One thread is enough: the library of
/// the files works for one at a time.
struct HistoryReading {
  HistoryReaders readers;
  TaskQueue queue{1};
};

/// Rows of histories from the result file, of a job that runs or of one that ended.
grpc::ServerWriteReactor<v1::StreamHistoryResponse>* stream_history(grpc::CallbackServerContext* context,
                                                                    const v1::StreamHistoryRequest& request,
                                                                    store::Store& store, Hub& hub,
                                                                    HistoryReading& reading,
                                                                    const std::filesystem::path& jobs_directory);

}  // namespace trajan
