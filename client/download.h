#pragma once

#include <filesystem>
#include <string>

#include "client/connection.h"
#include "client/interrupt.h"

namespace trajan::client {

/// Fetches one file of a job into a folder. What a broken download left is gone on with; every chunk's CRC and
/// the whole file's SHA-256 are verified before the file gets its name. Returns its path. An interrupt throws
/// CommandError (detached); the partial file stays for the next attempt. Throws CallError, CommandError.
std::filesystem::path download(Connection& connection, const std::string& job_id, const std::string& name,
                               const std::filesystem::path& folder, InterruptWatch* interrupt);

/// The SHA-256 of a file's bytes, hexadecimal. Throws CommandError if it cannot be read.
std::string file_sha256(const std::filesystem::path& file);

}  // namespace trajan::client
