// Ladders of cell sizes over scenes of the gallery: prints, as a Markdown table, what a study claims of each
// measure without knowing the exact value, and whether the true error is within it.
//   band_table [SCENE…]    all scenes if none is named
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "tests/verification/bands.h"
#include "tests/verification/gallery.h"

namespace trajan::verification {
namespace {

struct Counts {
  int cases = 0;
  int claims = 0;
  int covered = 0;
};

const char* name_of(accuracy::Behaviour behaviour) {
  switch (behaviour) {
    case accuracy::Behaviour::monotone:
      return "monotone";
    case accuracy::Behaviour::oscillating:
      return "oscillating";
    case accuracy::Behaviour::not_converging:
      return "not converging";
    case accuracy::Behaviour::constant:
      return "constant";
  }
  return "";
}

void print(const BandCase& band_case, Counts& counts) {
  const accuracy::Estimate& estimate = band_case.estimate;
  std::printf("| %s | %s%s |", band_case.scene.c_str(), band_case.measure.c_str(),
              band_case.is_answer ? "" : " (check)");
  for (const accuracy::Level& level : band_case.levels) std::printf(" %.7g: %.9g |", level.cell_size, level.value);
  std::printf(" %s | ", name_of(estimate.behaviour));
  if (estimate.order) std::printf("%.2f", *estimate.order);
  std::printf(" | %.2e | ", band_case.error());
  if (estimate.band)
    std::printf("%.2e%s | %s |\n", *estimate.band, estimate.asymptotic ? "" : " (cautious)",
                band_case.is_covered() ? "yes" : "NO");
  else
    std::printf("no claim | |\n");
  ++counts.cases;
  counts.claims += estimate.band.has_value();
  counts.covered += band_case.is_covered();
}

void print(const char* what, const Counts& counts) {
  std::printf("%s: %d cases, %d claims, %d (%.0f %%) within\n", what, counts.cases, counts.claims, counts.covered,
              100.0 * counts.covered / std::max(1, counts.claims));
}

void print_table(const std::vector<std::string>& names) {
  std::puts("| scene | measure | coarse | middle | fine | behaviour | order | error | band | within |");
  std::puts("|---|---|--:|--:|--:|---|--:|--:|--:|---|");
  constexpr double affordable =
      0.2;  // core-seconds at the scene's own cells; half the cells take about eight times as long
  Counts answers, checks;
  for (const std::string& name : names) {
    const bool cheap = run_scene(gallery_scene(name)).seconds < affordable;
    for (const BandCase& band_case : band_cases(name, cheap))
      print(band_case, band_case.is_answer ? answers : checks);
    std::fflush(stdout);
  }
  std::printf("\n");
  print("answers", answers);
  print("checks of rest and conservation, whose exact value is not the limit of small cells", checks);
}

}  // namespace
}  // namespace trajan::verification

int main(int argc, char** argv) {
  using namespace trajan::verification;
  try {
    const std::vector<std::string> names(argv + 1, argv + argc);
    print_table(names.empty() ? gallery_names() : names);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "band_table: %s\n", error.what());
    return 1;
  }
}
