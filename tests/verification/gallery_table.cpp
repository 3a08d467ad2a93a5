// Runs scenes of the gallery and prints what they measured beside the exact values, as a Markdown table.
//   gallery_table [SCENE…]           all scenes if none is named
//   gallery_table --history SCENE    the scene's histories as CSV instead
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "tests/verification/gallery.h"

namespace trajan::verification {
namespace {

void print_measures(const std::string& name) {
  const Outcome outcome = run_scene(gallery_scene(name));
  for (const MeasureValue& measure : outcome.measures) {
    // An error relative to an exact value is a percentage; one beside an exact 0 is absolute.
    const bool relative = measure.exact && *measure.exact != 0;
    std::printf("| %s | %s | %.6g | %.6g | ", name.c_str(), measure.name.c_str(), measure.value,
                measure.exact.value_or(0));
    std::printf(relative ? "%+.3f %% | %g %%" : "%.2g | %g", measure.error.value_or(0) * (relative ? 100 : 1),
                measure.tolerance.value_or(0) * (relative ? 100 : 1));
    std::printf(" | %lld | %lld | %.1f s |\n", static_cast<long long>(outcome.particles),
                static_cast<long long>(outcome.steps), outcome.seconds);
  }
  std::fflush(stdout);
}

void print_table(const std::vector<std::string>& names) {
  std::puts("| scene | measure | value | exact | error | tolerance | particles | steps | one core |");
  std::puts("|---|---|--:|--:|--:|--:|--:|--:|--:|");
  for (const std::string& name : names) print_measures(name);
}

void print_history(const std::string& name) {
  const Outcome outcome = run_scene(gallery_scene(name));
  std::printf("time");
  for (const std::string& column : outcome.columns) std::printf(",%s", column.c_str());
  for (std::size_t row = 0; row < outcome.time.size(); ++row) {
    std::printf("\n%.9g", outcome.time[row]);
    for (std::size_t i = 0; i < outcome.columns.size(); ++i) {
      std::printf(",%.9g", outcome.values[row * outcome.columns.size() + i]);
    }
  }
  std::printf("\n");
}

}  // namespace
}  // namespace trajan::verification

int main(int argc, char** argv) {
  using namespace trajan::verification;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    if (arguments.size() == 2 && arguments[0] == "--history") {
      print_history(arguments[1]);
    } else {
      print_table(arguments.empty() ? gallery_names() : arguments);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gallery_table: %s\n", error.what());
    return 1;
  }
}
