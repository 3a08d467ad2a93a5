#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trajan::client {

/// A point or a displacement: always x, y, z; those that a scene does not have are 0.
using Point = std::array<double, 3>;

/// One component of a field of all particles at one time.
struct ParticlePicture {
  double time = 0;
  std::string dimension;            ///< of the scene: "bar", "plane stress", "solid", ...
  std::vector<Point> position;      ///< current
  std::vector<Point> displacement;  ///< empty if the file has none
  std::vector<double> values;       ///< not a number where a particle has no such field
  std::string field;                ///< that the values are of, as it was asked for
  std::string label;                ///< of the values: "von Mises stress", "stress.xx", "damage"
  std::string units;                ///< of the scene
};

/// Reads the snapshot nearest to `time` (nothing: the last one) from a finished result file, which needs no
/// knowledge but its own names: the solver's code is not linked. `field`: "stress.xx", "velocity" (its
/// magnitude), "stress" (von Mises), "damage". Throws CommandError, which lists the fields if there is no
/// such one.
ParticlePicture read_snapshot(const std::filesystem::path& file, const std::string& field,
                              std::optional<double> time);

}  // namespace trajan::client
