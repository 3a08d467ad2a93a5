#pragma once

#include <stdexcept>
#include <string>

namespace trajan::client {

/// What the command line promises to scripts; `trajan --help` prints it.
enum class ExitCode {
  success = 0,
  job_failed = 1,     ///< the job failed or was cancelled, or the server refused the request
  usage = 2,          ///< wrong options, or a scene with mistakes
  not_reachable = 3,  ///< no server answers
  not_found = 4,      ///< no such job, file, column or scene
  local_failure = 5,  ///< a file could not be written, or a program that is needed is missing
  detached = 130,     ///< interrupted; the job goes on unless the server was private
};

/// A command cannot go on. `what()` is one clear message for people.
class CommandError : public std::runtime_error {
 public:
  CommandError(ExitCode exit_code, const std::string& message, std::string advice = {})
      : std::runtime_error(message), code(exit_code), hint(std::move(advice)) {}
  ExitCode code;
  std::string hint;  ///< what to do; may be empty
};

}  // namespace trajan::client
