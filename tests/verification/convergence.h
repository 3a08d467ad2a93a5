#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene.h"

/// How errors shrink with the cells, measured.
namespace trajan::verification {

/// The scene with other cells: `domain.cell_size`, and the constant `cell` from which the scenes of the
/// gallery compute where their probes are.
Scene with_cells(Scene scene, double cell_size);

/// Errors at several resolutions.
class ConvergenceTable {
 public:
  explicit ConvergenceTable(std::string title) : title_(std::move(title)) {}
  void add(double cell_size, double error);
  /// The slope of log |error| over log(cell size) that fits best, by least squares.
  double order() const;
  /// The error of the resolution that was added last.
  double last() const { return errors_.back(); }
  /// For people; goes to the test's output.
  void print() const;

 private:
  std::string title_;
  std::vector<double> cell_sizes_;
  std::vector<double> errors_;
};

}  // namespace trajan::verification
