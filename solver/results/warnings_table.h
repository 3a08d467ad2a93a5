#pragma once

#include <span>
#include <vector>

#include "solver/recorder.h"
#include "solver/results/dataset.h"

/// /warnings: one row per warning, of which no two have the same name: name, cause, remedy, and the step, the time
/// and the particle from which on numbers are doubtful. Texts have a fixed size, since rows are added while others
/// read.
namespace trajan::results {

class WarningsTable {
 public:
  static WarningsTable create(hid_t file);
  static WarningsTable open(hid_t file, Dataset::Checksums checksums);

  const std::vector<Warning>& warnings() const { return warnings_; }
  /// False if there is one of this name, or no room.
  bool add(const Warning& warning);

 private:
  explicit WarningsTable(Dataset rows) : rows_(std::move(rows)) {}

  Dataset rows_;
  std::vector<Warning> warnings_;
};

}  // namespace trajan::results
