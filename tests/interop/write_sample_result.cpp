#include <cstdio>
#include <exception>
#include <string_view>

#include "tests/unit/results/rehearsal.h"

namespace {

trajan::Dimension dimension_of(std::string_view name) {
  if (name == "solid") return trajan::Dimension::solid;
  return name == "axisymmetric" ? trajan::Dimension::axisymmetric : trajan::Dimension::plane_strain;
}

}  // namespace

/// write_sample_result DIRECTORY DIMENSION: leaves a finished result file with known values, and its XDMF file.
int main(int argc, char** argv) {
  using namespace trajan::results;
  if (argc != 3) return 2;
  try {
    const trajan::Model model = rehearsal::make_model(20, 4, dimension_of(argv[2]));
    write_xdmf(rehearsal::run_to_end(argv[1], model).path);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
