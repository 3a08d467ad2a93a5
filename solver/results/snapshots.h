#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/model/model.h"
#include "solver/recorder.h"
#include "solver/results/dataset.h"

namespace trajan::results {

/// Particles at some times, in /VTKHDF: VTKHDF 2.0, temporal PolyData, one vertex per particle. Arrays of
/// all times follow each other; those that never change (numbers, bodies, vertices) are stored once.
/// Vectors have three components, symmetric tensors six (xx, yy, zz, xy, yz, xz), others nine, whatever the
/// scene's dimension; those that it lacks are 0. A snapshot is committed when Steps/Values and then Steps'
/// attribute NSteps say so.
class Snapshots {
 public:
  /// Before the file goes to single-writer-multiple-reader mode.
  static Snapshots create(hid_t file, const Model& model);
  /// For writing on.
  static Snapshots open(hid_t file, const Model& model);

  /// Committed ones.
  hsize_t count() const;
  /// Writes or overwrites snapshot `index`, not yet its time.
  void write_arrays(hsize_t index, const Snapshot& snapshot);
  /// Commits a snapshot whose arrays have been written and flushed.
  void write_time(hsize_t index, double time);
  void write_count(hsize_t count);
  /// Drops the snapshots from `count` on. Throws if the first `file_bytes` of the file do not hold the others.
  void cut(hsize_t count, hsize_t file_bytes);

 private:
  void write_field(hsize_t index, Dataset& data, const RecordedField& field, std::span<const double> values);

  hsize_t particles_ = 0;
  Dataset points_;
  std::vector<Dataset> fields_;       ///< velocity, then the model's snapshot fields
  std::vector<RecordedField> kinds_;  ///< of fields_
  RecordedField position_;
  Handle steps_;
  std::vector<Dataset> offsets_;  ///< one integer row per snapshot
  std::vector<bool> advances_;    ///< whether the row is index * particles or zero
  Dataset parts_;
  Dataset times_;
};

}  // namespace trajan::results
