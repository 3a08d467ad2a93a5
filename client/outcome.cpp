#include "client/outcome.h"

#include <fmt/format.h>

#include <iostream>

#include "client/job_table.h"
#include "client/progress_display.h"
#include "client/terminal.h"

namespace trajan::client {

ExitCode report_outcome(const v1::Job& job) {
  if (job.state() == v1::SUCCEEDED) {
    if (!job.measures().empty()) print_table(std::cout, measure_table(job), OutputFormat::table);
    std::cout.flush();
    return ExitCode::success;
  }
  std::string message = fmt::format("job {} {}", job.job_id(), state_name(job.state()));
  if (job.has_failure()) message += ": " + failure_text(job.failure());
  say_error(message, job.failure().remedy());
  return ExitCode::job_failed;
}

}  // namespace trajan::client
