#pragma once

#include "client/connection.h"
#include "client/load_scene.h"
#include "client/table.h"

namespace trajan::client {

/// Queues a study of a scene; the request's kind and options are set. Prints every mistake of the scene and of the
/// runs' scenes, and throws CommandError (usage), if there are any.
v1::Job submit_study(Connection& connection, const LoadedScene& scene, v1::SubmitStudyRequest request);

v1::Study read_study(Connection& connection, const std::string& job_id);

/// Prints what an ended study found on standard output, and why it failed on standard error.
ExitCode report_study(Connection& connection, const v1::Job& job, OutputFormat output);

}  // namespace trajan::client
