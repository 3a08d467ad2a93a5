#pragma once

#include <filesystem>

#include "server/hub.h"
#include "server/store.h"
#include "server/stream.h"
#include "server/task_queue.h"
#include "trajan/v1/jobs.pb.h"

namespace trajan {

/// The bytes of a file that an ended job left, from `request.offset()` on. Whoever reads the result file
/// from its beginning is told DATA_LOSS at the end if the bytes do not match the digest that was taken
/// when it was written.
grpc::ServerWriteReactor<v1::ReadResultResponse>* read_result(grpc::CallbackServerContext* context,
                                                              const v1::ReadResultRequest& request,
                                                              store::Store& store, Hub& hub, TaskQueue& queue,
                                                              const std::filesystem::path& jobs_directory);

}  // namespace trajan
