#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/model/model.h"
#include "solver/recorder.h"
#include "solver/scene/scene.h"

/// Runs scenes in this process, from their text to their measures.
namespace trajan::verification {

/// Names of the gallery's scenes, in alphabetical order.
std::vector<std::string> gallery_names();

/// The file of a scene of the gallery.
std::filesystem::path gallery_file(std::string_view name);

/// A scene of the gallery. Throws std::runtime_error if it cannot be read.
Scene gallery_scene(std::string_view name);

/// A finished run.
struct Outcome {
  std::int64_t particles = 0;
  std::int64_t steps = 0;
  double seconds = 0;  ///< processor time of the run, on one thread
  std::vector<std::string> columns;
  std::vector<double> time;
  std::vector<double> values;  ///< (time.size(), columns.size()) row-major
  std::vector<MeasureValue> measures;
  std::vector<Warning> warnings;

  /// The history of a column. Throws std::out_of_range if there is none of this name.
  std::vector<double> history(std::string_view column) const;
  /// Throws std::out_of_range if there is none of this name.
  const MeasureValue& measure(std::string_view name) const;
};

/// Sees every snapshot of a run.
using SnapshotObserver = std::function<void(const Snapshot&)>;

/// Validates, runs on one thread and evaluates. Throws InvalidScene, or std::runtime_error if the run
/// diverges.
Outcome run_scene(
    const Scene& scene, const SnapshotObserver& observe = [](const Snapshot&) {});

}  // namespace trajan::verification
