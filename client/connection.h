#pragma once

#include <grpcpp/grpcpp.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "client/exit_code.h"
#include "trajan/v1/estimates.grpc.pb.h"
#include "trajan/v1/jobs.grpc.pb.h"
#include "trajan/v1/studies.grpc.pb.h"

namespace trajan::client {

/// Where the server is said to be: the option if it is given, otherwise $TRAJAN_SERVER, otherwise `server`
/// in the configuration file; empty if nobody says. A path is taken as a Unix socket.
std::string configured_address(const std::string& option);
/// `$XDG_CONFIG_HOME/trajan/config`, or `~/.config/trajan/config`.
std::string configuration_file();

/// A call failed: the details that the server attached, if any.
class CallError : public CommandError {
 public:
  CallError(const grpc::Status& status, v1::ErrorDetails details, const std::string& address);
  grpc::StatusCode status;
  v1::ErrorDetails details;
};

/// Throws CallError unless the call succeeded.
void require_ok(const grpc::Status& status, const grpc::ClientContext& context, const std::string& address);

/// Whether the server may be back soon: it does not answer, or it ended the call because it shuts down.
bool may_come_back(const grpc::Status& status);
/// How long a stream tries to reach a server that does not answer.
inline constexpr std::chrono::seconds silence_allowed{60};

/// A connection to a server. Calls may come from several threads.
class Connection {
 public:
  explicit Connection(std::string address);

  const std::string& address() const { return address_; }
  v1::Jobs::Stub& jobs() { return *jobs_; }
  bool answers_within(std::chrono::milliseconds patience);

  /// Makes a short call, again and again with growing pauses while the server is unavailable, for
  /// at most `patience`: only for calls that may be repeated. Throws CallError.
  template <typename Request, typename Response>
  Response call(grpc::Status (v1::Jobs::Stub::*method)(grpc::ClientContext*, const Request&, Response*),
                const Request& request) {
    Response response;
    repeat([&](grpc::ClientContext& context) { return (jobs_.get()->*method)(&context, request, &response); });
    return response;
  }
  template <typename Request, typename Response>
  Response call(grpc::Status (v1::Studies::Stub::*method)(grpc::ClientContext*, const Request&, Response*),
                const Request& request) {
    Response response;
    repeat([&](grpc::ClientContext& context) { return (studies_.get()->*method)(&context, request, &response); });
    return response;
  }
  template <typename Request, typename Response>
  Response call(grpc::Status (v1::Estimates::Stub::*method)(grpc::ClientContext*, const Request&, Response*),
                const Request& request) {
    Response response;
    repeat(
        [&](grpc::ClientContext& context) { return (estimates_.get()->*method)(&context, request, &response); });
    return response;
  }

 private:
  void repeat(const std::function<grpc::Status(grpc::ClientContext&)>& attempt);

  std::string address_;
  std::shared_ptr<grpc::Channel> channel_;
  std::unique_ptr<v1::Jobs::Stub> jobs_;
  std::unique_ptr<v1::Studies::Stub> studies_;
  std::unique_ptr<v1::Estimates::Stub> estimates_;
};

/// Pauses between attempts: 0.1 s, twice as long each time, at most 2 s.
class Backoff {
 public:
  void pause();
  void reset() { next_ = first; }

 private:
  static constexpr std::chrono::milliseconds first{100};
  static constexpr std::chrono::milliseconds longest{2000};
  std::chrono::milliseconds next_ = first;
};

}  // namespace trajan::client
