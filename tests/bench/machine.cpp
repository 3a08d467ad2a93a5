// What one core of the machine can do, measured in the same run: the yardstick of all other figures.
#include <benchmark/benchmark.h>

#include <array>
#include <experimental/simd>
#include <vector>

namespace {

/// McCalpin's triad a = b + s c (1995), out of the caches: bytes per second, counting two reads and a write.
void triad(benchmark::State& state) {
  constexpr std::size_t count = 8 << 20;
  std::vector<double> a(count, 0.0), b(count, 1.0), c(count, 2.0);
  for (auto _ : state) {
    for (std::size_t i = 0; i < count; ++i) a[i] = b[i] + 3 * c[i];
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * count * 3 * sizeof(double)));
}

using Lanes = std::experimental::native_simd<double>;

/// Multiply-adds in registers, in more independent chains than the units have stages: operations per second.
void multiply_adds(benchmark::State& state) {
  constexpr int chains = 12, rounds = 1000;
  std::array<Lanes, chains> sums{};
  const volatile double factor = 0.999, term = 1e-3;
  const Lanes factors = factor, terms = term;
  for (auto _ : state) {
    for (int round = 0; round < rounds; ++round) {
#pragma GCC unroll 12
      for (int chain = 0; chain < chains; ++chain) sums[chain] = sums[chain] * factors + terms;
    }
    benchmark::DoNotOptimize(sums);
  }
  state.counters["flop/s"] = benchmark::Counter(2.0 * static_cast<double>(Lanes::size()) * chains * rounds,
                                                benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(triad);
BENCHMARK(multiply_adds);

}  // namespace
