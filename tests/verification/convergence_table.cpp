// Runs the manufactured solutions by every scheme and shape function with finer and finer cells, and prints the
// errors and measured orders as a Markdown table.
//   convergence_table [SCENE…]    all manufactured solutions if none is named
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "solver/model/validate.h"
#include "solver/schemes/scheme.h"
#include "tests/verification/convergence.h"
#include "tests/verification/gallery.h"
#include "tests/verification/manufactured.h"

namespace trajan::verification {
namespace {

constexpr int levels = 3;

void print_row(const ManufacturedSolution& solution, const std::string& scheme, const std::string& shape) {
  const Scene scene = with_numerics(gallery_scene(solution.scene), scheme, shape);
  ConvergenceTable table(solution.scene);
  std::printf("| %s | %s | %s |", solution.scene, scheme.c_str(), shape.c_str());
  try {
    double cell_size = 4 * scene.domain.cell_size;
    for (int level = 0; level < levels; ++level, cell_size /= 2) {
      table.add(cell_size, displacement_error(with_cells(scene, cell_size), solution));
      std::printf(" %.2e |", table.last());
    }
    std::printf(" %.2f |\n", table.order());
  } catch (const InvalidScene&) {
    std::printf(" refused |\n");
  } catch (const std::runtime_error&) {
    std::printf(" diverged |\n");
  }
  std::fflush(stdout);
}

void print_table(const ManufacturedSolution& solution) {
  for (const std::string_view scheme : scheme_names()) {
    for (const std::string_view shape : shape_names())
      print_row(solution, std::string(scheme), std::string(shape));
  }
}

}  // namespace
}  // namespace trajan::verification

int main(int argc, char** argv) {
  using namespace trajan::verification;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    std::puts("| solution | scheme | shape functions | coarse | middle | fine | order |");
    std::puts("|---|---|---|--:|--:|--:|--:|");
    for (const ManufacturedSolution& solution : manufactured_solutions()) {
      if (arguments.empty() || std::ranges::count(arguments, solution.scene)) print_table(solution);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "convergence_table: %s\n", error.what());
    return 1;
  }
}
