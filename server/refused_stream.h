#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <exception>

#include "server/status.h"

namespace trajan {

/// A call that ends with an error before it began.
template <class Response>
class RefusedStream final : public grpc::ServerWriteReactor<Response> {
 public:
  explicit RefusedStream(const grpc::Status& status) { this->Finish(status); }

 private:
  void OnDone() final { delete this; }
};

/// Starts a stream; what `start` throws refuses the call.
template <class Response, class Start>
grpc::ServerWriteReactor<Response>* start_or_refuse(grpc::CallbackServerContext& context, Start&& start) {
  try {
    return start();
  } catch (...) {
    return new RefusedStream<Response>(to_status(context, std::current_exception()));
  }
}

}  // namespace trajan
