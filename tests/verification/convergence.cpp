#include "tests/verification/convergence.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace trajan::verification {

Scene with_cells(Scene scene, double cell_size) {
  scene.domain.cell_size = cell_size;
  const auto cell = std::ranges::find(scene.constants, "cell", &Constant::name);
  if (cell != scene.constants.end()) cell->value = std::to_string(cell_size);
  return scene;
}

void ConvergenceTable::add(double cell_size, double error) {
  cell_sizes_.push_back(cell_size);
  errors_.push_back(error);
}

double ConvergenceTable::order() const {
  const auto n = static_cast<double>(cell_sizes_.size());
  double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  for (std::size_t i = 0; i < cell_sizes_.size(); ++i) {
    const double x = std::log(cell_sizes_[i]);
    const double y = std::log(std::abs(errors_[i]));
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

void ConvergenceTable::print() const {
  std::printf("%s\n%12s %14s %8s\n", title_.c_str(), "cell size", "error", "order");
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    std::printf("%12.6g %14.3e", cell_sizes_[i], errors_[i]);
    if (i > 0) {
      const double ratio = std::log(std::abs(errors_[i - 1] / errors_[i]));
      std::printf(" %8.2f", ratio / std::log(cell_sizes_[i - 1] / cell_sizes_[i]));
    }
    std::printf("\n");
  }
  std::printf("fitted order %.2f\n", order());
}

}  // namespace trajan::verification
