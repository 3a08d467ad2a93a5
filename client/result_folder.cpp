#include "client/result_folder.h"

#include <fmt/format.h>

#include "client/download.h"

namespace trajan::client {

namespace fs = std::filesystem;

fs::path result_folder(const v1::Job& job, const std::string& folder) {
  return folder.empty() ? fs::path(job.scene_name() + "-" + job.job_id()) : fs::path(folder);
}

std::vector<std::string> fetch_results(Connection& connection, const v1::Job& job, const fs::path& folder,
                                       InterruptWatch* interrupt) {
  if (!job.has_result()) {
    throw CommandError(ExitCode::not_found, fmt::format("job {} has no result file yet", job.job_id()),
                       fmt::format("wait for it with: trajan watch {}", job.job_id()));
  }
  const fs::path result = folder / job.result().name();
  if (!fs::exists(result) || file_sha256(result) != job.result().sha256()) {
    download(connection, job.job_id(), job.result().name(), folder, interrupt);
  }
  std::vector<std::string> files{result.string()};
  try {
    files.push_back(download(connection, job.job_id(), "result.xmf2", folder, interrupt).string());
  } catch (const CallError& error) {
    if (error.status != grpc::StatusCode::NOT_FOUND) throw;  // a job that ended early may have none
  }
  return files;
}

}  // namespace trajan::client
