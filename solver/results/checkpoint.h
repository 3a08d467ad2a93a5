#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "solver/recorder.h"

/// checkpoint.h5: attributes `sample`, `step`, `time` and `identity` of the run, and the state's arrays by
/// their names in /arrays, with checksums.
namespace trajan::results {

/// Replaces the checkpoint at `path` at once: after a kill there is the old one or the new one. Durable
/// when it returns. Throws std::runtime_error; the old one stays then.
void write_checkpoint(const std::filesystem::path& path, const std::string& identity,
                      const Checkpoint& checkpoint);

/// Empty if there is none, it is damaged or it belongs to another run.
std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path, const std::string& identity);

}  // namespace trajan::results
