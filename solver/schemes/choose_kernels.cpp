#include "solver/schemes/kernels.h"

namespace trajan {

#ifdef TRAJAN_DISPATCH

namespace x86_64_v2 {
extern const Kernels compiled_kernels;
}
namespace x86_64_v3 {
extern const Kernels compiled_kernels;
}
namespace x86_64_v4 {
extern const Kernels compiled_kernels;
}

const Kernels& kernels() {
  static const Kernels& fastest = [&]() -> const Kernels& {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
      return x86_64_v4::compiled_kernels;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
        __builtin_cpu_supports("fma"))
      return x86_64_v3::compiled_kernels;
    return x86_64_v2::compiled_kernels;
  }();
  return fastest;
}

#else

inline namespace TRAJAN_INSTRUCTION_SET {
extern const Kernels compiled_kernels;
}

const Kernels& kernels() { return compiled_kernels; }

#endif

}  // namespace trajan
