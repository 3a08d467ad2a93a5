#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trajan::client {

/// One component of a field of all particles at one time.
struct ParticlePicture {
  double time = 0;
  std::vector<std::array<double, 2>> position;      ///< current
  std::vector<std::array<double, 2>> displacement;  ///< empty if the file has none
  std::vector<double> values;
  std::string units;       ///< of the scene
  std::string scene_text;  ///< as it was submitted
};

/// Reads the snapshot nearest to `time` (nothing: the last one) from a finished result file, which needs no
/// knowledge but its own names: the solver's code is not linked. `field`: "stress.xx", "velocity" (its
/// magnitude), "stress" (von Mises). Throws CommandError, which lists the fields if there is no such one.
ParticlePicture read_snapshot(const std::filesystem::path& file, const std::string& field,
                              std::optional<double> time);

}  // namespace trajan::client
