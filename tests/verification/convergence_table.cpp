// Runs the manufactured solutions by schemes, shape functions and transfers with finer and finer cells, and prints
// the errors and measured orders as a Markdown table.
//   convergence_table                          everything, which takes a quarter of an hour
//   convergence_table SOLUTION                 one manufactured solution
//   convergence_table SOLUTION WORD…           only the rows whose names are among the words, for example
//                                              MUSL TLMPM cubic_bspline FLIP FMPM; a number is that of the
//                                              particles per cell side
#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "solver/model/validate.h"
#include "solver/schemes/scheme.h"
#include "solver/transfers/transfer.h"
#include "tests/verification/convergence.h"
#include "tests/verification/gallery.h"
#include "tests/verification/manufactured.h"

namespace trajan::verification {
namespace {

constexpr int levels = 3;

struct Row {
  std::string scheme, shape, transfer;
  std::optional<int> particles_per_cell_side;
};

/// Whether the words, if there are any of this kind, name it.
template <typename Names>
bool wanted(const std::string& name, const Names& kind, const std::vector<std::string>& words) {
  const auto asked = [&](std::string_view other) { return std::ranges::count(words, other) > 0; };
  return asked(name) || std::ranges::none_of(kind, asked);
}

std::optional<int> number_among(const std::vector<std::string>& words) {
  const auto is_number = [](const std::string& word) {
    return word.find_first_not_of("0123456789") == std::string::npos;
  };
  const auto found = std::ranges::find_if(words, is_number);
  if (found == words.end()) return std::nullopt;
  return std::stoi(*found);
}

std::vector<Row> rows(const std::vector<std::string>& words) {
  std::vector<Row> result;
  for (const std::string_view scheme : scheme_names())
    for (const std::string_view shape : shape_names())
      for (const std::string_view transfer : transfer_names()) {
        Row row{std::string(scheme), std::string(shape), std::string(transfer), number_among(words)};
        if (wanted(row.scheme, scheme_names(), words) && wanted(row.shape, shape_names(), words) &&
            wanted(row.transfer, transfer_names(), words))
          result.push_back(row);
      }
  return result;
}

void print_row(const ManufacturedSolution& solution, const Row& row) {
  Scene scene = with_numerics(gallery_scene(solution.scene), row.scheme, row.shape, row.transfer);
  if (row.particles_per_cell_side) scene.bodies[0].particles_per_cell_side = *row.particles_per_cell_side;
  ConvergenceTable table(solution.scene);
  std::printf("| %s | %s | %s | %s |", solution.scene, row.scheme.c_str(), row.shape.c_str(),
              row.transfer.c_str());
  try {
    double cell_size = solution.coarsest;
    for (int level = 0; level < levels; ++level, cell_size /= 2) {
      table.add(cell_size, displacement_error(with_cells(scene, cell_size), solution));
      std::printf(" %.2e |", table.last());
      std::fflush(stdout);
    }
    std::printf(" %.2f |\n", table.order());
  } catch (const InvalidScene&) {
    std::printf(" refused |\n");
  } catch (const std::runtime_error&) {
    std::printf(" diverged |\n");
  }
}

}  // namespace
}  // namespace trajan::verification

int main(int argc, char** argv) {
  using namespace trajan::verification;
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    std::puts("| solution | scheme | shape functions | transfer | coarse | middle | fine | order |");
    std::puts("|---|---|---|---|--:|--:|--:|--:|");
    for (const ManufacturedSolution& solution : manufactured_solutions()) {
      if (!words.empty() && words[0] != solution.scene) continue;
      for (const Row& row : rows(words)) print_row(solution, row);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "convergence_table: %s\n", error.what());
    return 1;
  }
}
