// One measurement in one process, as a line of JSON; bench.py runs them all.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "solver/schemes/kernels.h"
#include "tests/bench/machine.h"
#include "tests/bench/measurement.h"

namespace trajan::bench {
namespace {

void print(const Case& of, int threads, const Measurement& m) {
  std::printf("{\"case\": \"%s\", \"explicit\": %s, \"particles\": %lld, \"threads\": %d, \"steps\": %lld, ",
              of.choice.name.c_str(), of.choice.kind == Kind::explicit_steps ? "true" : "false",
              static_cast<long long>(m.particles), threads, static_cast<long long>(m.steps));
  std::printf("\"start_s\": %.6g, \"validation_s\": %.6g, \"solver_bytes\": %lld, \"peak_bytes\": %lld, ", m.start,
              m.validation, static_cast<long long>(m.solver_bytes), static_cast<long long>(m.peak_bytes));
  std::printf("\"bytes_moved\": %.6g, \"multiply_adds\": %.6g, \"ns\": [", m.bytes_moved, m.multiply_adds);
  for (std::size_t i = 0; i < m.nanoseconds.size(); ++i) std::printf("%s%.6g", i ? ", " : "", m.nanoseconds[i]);
  std::printf("]}\n");
}

int run(int count, char** words) {
  if (count == 2 && std::strcmp(words[1], "--list") == 0) {
    for (const Case& one : cases()) std::printf("%s\n", one.choice.name.c_str());
    return 0;
  }
  if (count == 2 && std::strcmp(words[1], "--machine") == 0) {
    std::printf("{\"instruction_set\": \"%s\", \"triad_bytes_per_s\": %.6g, \"multiply_add_flop_per_s\": %.6g}\n",
                kernels().instruction_set, triad(), multiply_adds());
    return 0;
  }
  if (count == 4)
    for (const Case& one : cases())
      if (one.choice.name == words[1]) {
        const int threads = std::atoi(words[3]);
        print(one, threads, measure(one, std::atof(words[2]), threads));
        return 0;
      }
  std::fprintf(stderr, "usage: trajan_bench --list | --machine | CASE PARTICLES THREADS\n");
  return 2;
}

}  // namespace
}  // namespace trajan::bench

int main(int count, char** words) { return trajan::bench::run(count, words); }
