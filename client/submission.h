#pragma once

#include <string>
#include <vector>

#include "client/connection.h"
#include "client/fidelity.h"
#include "client/load_scene.h"

namespace trajan::client {

struct SubmitOptions {
  std::vector<std::string> labels;  ///< "key=value"
  int priority = 0;
  std::string request_id;  ///< empty: a random one
  FidelityOptions fidelity;
};

/// Checks and queues a scene. A submit whose answer was lost is repeated under the same request id, so that
/// it never makes two jobs. Throws CommandError.
v1::Job submit_scene(Connection& connection, const LoadedScene& scene, const SubmitOptions& options);

/// From "key=value". Throws CommandError (usage).
google::protobuf::Map<std::string, std::string> parse_labels(const std::vector<std::string>& labels);

/// A random UUID (RFC 4122, version 4).
std::string random_id();

}  // namespace trajan::client
