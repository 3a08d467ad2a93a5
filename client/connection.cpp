#include "client/connection.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <thread>

#include "proto/default_paths.h"

namespace trajan::client {
namespace {

constexpr std::chrono::seconds first_answer_allowed{10};
constexpr std::chrono::seconds call_deadline{30};
constexpr const char* details_key = "trajan-error-bin";

ExitCode exit_code_of(grpc::StatusCode status) {
  switch (status) {
    case grpc::StatusCode::UNAVAILABLE:
    case grpc::StatusCode::DEADLINE_EXCEEDED:
      return ExitCode::not_reachable;
    case grpc::StatusCode::NOT_FOUND:
      return ExitCode::not_found;
    case grpc::StatusCode::INVALID_ARGUMENT:
    case grpc::StatusCode::OUT_OF_RANGE:
      return ExitCode::usage;
    default:
      return ExitCode::job_failed;
  }
}

std::string message_of(const grpc::Status& status, const std::string& address) {
  if (status.error_code() == grpc::StatusCode::UNAVAILABLE) {
    return fmt::format("the server at {} does not answer ({})", address, status.error_message());
  }
  if (status.error_code() == grpc::StatusCode::INTERNAL)
    return "the server has a defect: " + status.error_message();
  return status.error_message();
}

std::string hint_of(const grpc::Status& status) {
  switch (status.error_code()) {
    case grpc::StatusCode::UNAVAILABLE:
      return "start one with `trajand serve`, or say where it is with --server or $TRAJAN_SERVER";
    case grpc::StatusCode::NOT_FOUND:
      return "`trajan ls` lists the jobs";
    case grpc::StatusCode::RESOURCE_EXHAUSTED:
      return "try again later";
    default:
      return {};
  }
}

v1::ErrorDetails details_of(const grpc::ClientContext& context) {
  v1::ErrorDetails details;
  const auto& metadata = context.GetServerTrailingMetadata();
  const auto entry = metadata.find(details_key);
  if (entry != metadata.end()) {
    details.ParseFromArray(entry->second.data(), static_cast<int>(entry->second.size()));
  }
  return details;
}

}  // namespace

std::string configuration_file() {
  const char* folder = std::getenv("XDG_CONFIG_HOME");
  if (folder != nullptr && *folder == '/') return std::string(folder) + "/trajan/config";
  const char* home = std::getenv("HOME");
  return std::string(home == nullptr ? "" : home) + "/.config/trajan/config";
}

std::string configured_address(const std::string& option) {
  std::string address = option;
  if (const char* variable = std::getenv("TRAJAN_SERVER"); address.empty() && variable != nullptr)
    address = variable;
  if (std::ifstream file(configuration_file()); address.empty() && file) {
    for (const CLI::ConfigItem& item : CLI::ConfigTOML().from_config(file)) {
      if (item.name == "server" && !item.inputs.empty()) address = item.inputs.front();
    }
  }
  return address.starts_with('/') ? "unix:" + address : address;
}

CallError::CallError(const grpc::Status& failed, v1::ErrorDetails attached, const std::string& address)
    : CommandError(exit_code_of(failed.error_code()), message_of(failed, address), hint_of(failed)),
      status(failed.error_code()),
      details(std::move(attached)) {}

void require_ok(const grpc::Status& status, const grpc::ClientContext& context, const std::string& address) {
  if (!status.ok()) throw CallError(status, details_of(context), address);
}

bool may_come_back(const grpc::Status& status) {
  return status.error_code() == grpc::StatusCode::UNAVAILABLE ||
         status.error_code() == grpc::StatusCode::CANCELLED;
}

Connection::Connection(std::string address) : address_(std::move(address)) {
  if (address_.empty()) address_ = default_address();
  grpc::ChannelArguments arguments;
  // A peer that vanished without a word is noticed within half a minute.
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, 20'000);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 10'000);
  // A server that restarts is found again soon.
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, 100);
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 1'000);
  arguments.SetMaxReceiveMessageSize(16 << 20);
  channel_ = grpc::CreateCustomChannel(address_, grpc::InsecureChannelCredentials(), arguments);
  jobs_ = v1::Jobs::NewStub(channel_);
  studies_ = v1::Studies::NewStub(channel_);
  estimates_ = v1::Estimates::NewStub(channel_);
}

bool Connection::answers_within(std::chrono::milliseconds wait) {
  return channel_->WaitForConnected(std::chrono::system_clock::now() + wait);
}

void Connection::repeat(const std::function<grpc::Status(grpc::ClientContext&)>& attempt) {
  const auto give_up = std::chrono::steady_clock::now() + first_answer_allowed;
  for (Backoff backoff;; backoff.pause()) {
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() + call_deadline);
    const grpc::Status status = attempt(context);
    if (!may_come_back(status) || std::chrono::steady_clock::now() > give_up)
      return require_ok(status, context, address_);
  }
}

void Backoff::pause() {
  std::this_thread::sleep_for(next_);
  next_ = std::min(2 * next_, longest);
}

}  // namespace trajan::client
