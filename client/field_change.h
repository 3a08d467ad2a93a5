#pragma once

#include <string>

#include "trajan/v1/scene.pb.h"

namespace trajan::client {

/// Changes one field of a scene as `--set PATH=VALUE` says it; see proto/field_change.h. Throws CommandError
/// (usage).
std::string change_field(v1::Scene& scene, const std::string& change);

}  // namespace trajan::client
