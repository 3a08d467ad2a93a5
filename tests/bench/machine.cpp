#include "tests/bench/machine.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <experimental/simd>
#include <vector>

namespace trajan::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// The least of some repetitions, seconds: what the machine can do when nobody disturbs it.
template <class Of>
double least_seconds(int repetitions, Of&& of) {
  double least = HUGE_VAL;
  for (int i = 0; i < repetitions; ++i) {
    const Clock::time_point begin = Clock::now();
    of();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - begin).count());
  }
  return least;
}

/// The compiler must take it that somebody reads and changes what is behind the pointer.
void touch(void* pointer) { asm volatile("" : : "r"(pointer) : "memory"); }

using Lanes = std::experimental::native_simd<double>;

}  // namespace

double triad() {
  constexpr std::size_t count = 8 << 20;
  std::vector<double> a(count, 0.0), b(count, 1.0), c(count, 2.0);
  const double seconds = least_seconds(10, [&] {
    for (std::size_t i = 0; i < count; ++i) a[i] = b[i] + 3 * c[i];
    touch(a.data());
  });
  return static_cast<double>(count * 3 * sizeof(double)) / seconds;
}

double multiply_adds() {
  constexpr int chains = 12, rounds = 1'000'000;
  std::array<Lanes, chains> sums{};
  const volatile double factor = 0.999, term = 1e-3;
  const Lanes factors = factor, terms = term;
  const double seconds = least_seconds(10, [&] {
    for (int round = 0; round < rounds; ++round) {
#pragma GCC unroll 12
      for (int chain = 0; chain < chains; ++chain) sums[chain] = sums[chain] * factors + terms;
    }
    touch(&sums);
  });
  return 2.0 * static_cast<double>(Lanes::size()) * chains * rounds / seconds;
}

}  // namespace trajan::bench
