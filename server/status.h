#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <exception>
#include <utility>

namespace trajan {

/// The status for what was thrown; a ServiceError's details go into the trailing metadata
/// `trajan-error-bin` of `context`. Anything but a ServiceError is a defect and is logged. Null: OK.
grpc::Status to_status(grpc::CallbackServerContext& context, const std::exception_ptr& error);

/// Does `work` and finishes the call with what it throws, or OK.
template <class Work>
void answer(grpc::CallbackServerContext& context, grpc::ServerUnaryReactor& reactor, Work&& work) {
  std::exception_ptr error;
  try {
    std::forward<Work>(work)();
  } catch (...) {
    error = std::current_exception();
  }
  reactor.Finish(to_status(context, error));
}

}  // namespace trajan
