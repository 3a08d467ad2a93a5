#include "client/study.h"

#include <iostream>

#include "client/outcome.h"
#include "client/study_table.h"
#include "client/submission.h"

namespace trajan::client {

v1::Job submit_study(Connection& connection, const LoadedScene& scene, v1::SubmitStudyRequest request) {
  if (!scene.text.diagnostics().empty()) fail_for_mistakes(scene, {});
  *request.mutable_scene() = scene.text.scene();
  if (request.request_id().empty()) request.set_request_id(random_id());
  try {
    return connection.call(&v1::Studies::Stub::SubmitStudy, request);
  } catch (const CallError& error) {
    auto violations = error.details.violations();
    if (violations.empty()) throw;
    for (v1::Violation& violation : violations) {
      if (!violation.run().empty()) violation.set_problem(violation.problem() + " (" + violation.run() + ")");
    }
    fail_for_mistakes(scene, violations);
  }
}

v1::Study read_study(Connection& connection, const std::string& job_id) {
  v1::GetStudyRequest request;
  request.set_job_id(job_id);
  return connection.call(&v1::Studies::Stub::GetStudy, request);
}

ExitCode report_study(Connection& connection, const v1::Job& job, OutputFormat output) {
  print_study_table(std::cout, read_study(connection, job.job_id()), output);
  std::cout.flush();
  return job.state() == v1::SUCCEEDED ? ExitCode::success : report_outcome(job);
}

}  // namespace trajan::client
