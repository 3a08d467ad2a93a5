#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/connection.h"
#include "client/interrupt.h"

namespace trajan::client {

/// `folder`, or `<scene>-<job id>` if it is empty.
std::filesystem::path result_folder(const v1::Job& job, const std::string& folder);

/// Downloads the result file, and `result.xmf2` if the job has one. A file that is there with the right
/// digest is kept. Returns the paths. Throws CommandError.
std::vector<std::string> fetch_results(Connection& connection, const v1::Job& job,
                                       const std::filesystem::path& folder, InterruptWatch* interrupt);

}  // namespace trajan::client
