#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace trajan {

/// Starts a process in a process group of its own, with default signals, no input, its output going to
/// our stderr, and no other open file of ours. Throws std::system_error.
pid_t spawn(const std::vector<std::string>& command);

}  // namespace trajan
