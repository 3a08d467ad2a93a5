#pragma once

#include "client/exit_code.h"
#include "trajan/v1/jobs.pb.h"

namespace trajan::client {

/// Prints how an ended job ended: its measures on standard output, why it failed on standard error.
ExitCode report_outcome(const v1::Job& job);

}  // namespace trajan::client
