#pragma once

#include "solver/schemes/kernels.h"

/// The kernels for x86-64-v3 that tests compile. To be included once in a program: it defines what they have not.
namespace trajan {
namespace x86_64_v3 {
extern const Kernels compiled_kernels;
}
/// No cases with floats are compared or counted.
namespace x86_64_v3_float {
extern const GridKernels compiled_grid_kernels;
const GridKernels compiled_grid_kernels{};
}  // namespace x86_64_v3_float
}  // namespace trajan
