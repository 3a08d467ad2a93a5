#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace trajan {

/// Where a server keeps its state unless it is told otherwise: `$XDG_STATE_HOME/trajan`, or
/// `~/.local/state/trajan` (XDG base directory specification 0.8).
inline std::filesystem::path default_state_directory() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && *state == '/') return std::filesystem::path(state) / "trajan";
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home == nullptr ? "/" : home) / ".local/state/trajan";
}

/// The Unix socket of a server with this state directory. Both ends of the API must agree on it.
inline std::filesystem::path socket_path(const std::filesystem::path& state_directory) {
  return state_directory / "trajan.sock";
}

/// The gRPC address of the default server.
inline std::string default_address() { return "unix:" + socket_path(default_state_directory()).string(); }

}  // namespace trajan
