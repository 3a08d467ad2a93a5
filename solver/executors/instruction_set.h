#pragma once

/// Code that is compiled several times, once for each instruction set, lives in an inline namespace that
/// is named after it, so that the linker never takes one set's copy of a function for another's.
#ifndef TRAJAN_INSTRUCTION_SET
#define TRAJAN_INSTRUCTION_SET baseline
#endif

/// The number type of what particles do on the grid: weights, velocities, what is gathered and scattered.
#ifndef TRAJAN_REAL
#define TRAJAN_REAL double
#endif
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {
using Real = TRAJAN_REAL;
}
}  // namespace trajan

/// Inlines all that a stage calls, so that its loop vectorises. With a sanitizer's checks in every line that
/// would only take the compiler a minute per law.
#ifdef TRAJAN_SANITIZED
#define TRAJAN_FLATTEN
#else
#define TRAJAN_FLATTEN [[gnu::flatten]]
#endif
