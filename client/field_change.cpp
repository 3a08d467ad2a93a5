#include "client/field_change.h"

#include <fmt/format.h>

#include "client/exit_code.h"
#include "client/utf8.h"
#include "proto/field_change.h"

namespace trajan::client {

std::string change_field(v1::Scene& scene, const std::string& change) {
  if (first_invalid_utf8(change) != std::string::npos)
    throw CommandError(ExitCode::usage, "--set: the value is not UTF-8");
  try {
    return trajan::change_field(scene, change);
  } catch (const FieldChangeError& error) {
    throw CommandError(ExitCode::usage, fmt::format("--set {}: {}", change, error.what()), error.hint);
  }
}

}  // namespace trajan::client
