#include "client/submission.h"

#include <fmt/format.h>

#include <random>

namespace trajan::client {

std::string random_id() {
  std::random_device random;
  std::uint32_t words[4];
  for (std::uint32_t& word : words) word = random();
  words[1] = (words[1] & 0xFFFF0FFF) | 0x00004000;  // version 4
  words[2] = (words[2] & 0x3FFFFFFF) | 0x80000000;  // variant 1
  return fmt::format("{:08x}-{:04x}-{:04x}-{:04x}-{:04x}{:08x}", words[0], words[1] >> 16, words[1] & 0xFFFF,
                     words[2] >> 16, words[2] & 0xFFFF, words[3]);
}

google::protobuf::Map<std::string, std::string> parse_labels(const std::vector<std::string>& labels) {
  google::protobuf::Map<std::string, std::string> parsed;
  for (const std::string& label : labels) {
    const std::size_t equals = label.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw CommandError(ExitCode::usage, fmt::format("\"{}\" is not a label", label), "write --label key=value");
    }
    parsed[label.substr(0, equals)] = label.substr(equals + 1);
  }
  return parsed;
}

v1::Job submit_scene(Connection& connection, const LoadedScene& scene, const SubmitOptions& options) {
  v1::SubmitJobRequest request;
  *request.mutable_labels() = parse_labels(options.labels);
  const v1::Fidelity fidelity = parse_fidelity(options.fidelity);
  if (fidelity.kind_case() != v1::Fidelity::KIND_NOT_SET) *request.mutable_fidelity() = fidelity;
  check_scene(connection, scene);
  request.set_request_id(options.request_id.empty() ? random_id() : options.request_id);
  *request.mutable_scene() = scene.text.scene();
  request.set_priority(options.priority);
  try {
    return connection.call(&v1::Jobs::Stub::SubmitJob, request);
  } catch (const CallError& error) {
    if (error.details.violations().empty()) throw;
    fail_for_mistakes(scene, error.details.violations());
  }
}

}  // namespace trajan::client
