#pragma once

#include <grpcpp/support/status_code_enum.h>

#include <stdexcept>
#include <string>

#include "trajan/v1/jobs.pb.h"

namespace trajan {

/// What a caller is told: a canonical code, a message for people and typed details for programs.
class ServiceError : public std::runtime_error {
 public:
  /// `reason` is stable and in upper case.
  ServiceError(grpc::StatusCode code, const std::string& reason, const std::string& message)
      : std::runtime_error(message), code_(code) {
    details_.set_reason(reason);
  }

  grpc::StatusCode code() const { return code_; }
  v1::ErrorDetails& details() { return details_; }
  const v1::ErrorDetails& details() const { return details_; }

 private:
  grpc::StatusCode code_;
  v1::ErrorDetails details_;
};

}  // namespace trajan
