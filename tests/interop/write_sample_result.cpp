#include <cstdio>
#include <exception>

#include "tests/unit/results/rehearsal.h"

/// write_sample_result DIRECTORY: leaves a finished result file with known values, and its XDMF file.
int main(int argc, char** argv) {
  using namespace trajan::results;
  if (argc != 2) return 2;
  try {
    const trajan::Model model = rehearsal::make_model(20, 4);
    write_xdmf(rehearsal::run_to_end(argv[1], model).path);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
