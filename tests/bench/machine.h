#pragma once

/// What one core of the machine can do, measured in the same run: the yardstick of all other figures.
namespace trajan::bench {

/// McCalpin's triad a = b + s c (1995), out of the caches: bytes per second, counting two reads and a write.
double triad();

/// Multiply-adds in registers, in more independent chains than the units have stages: floating point operations
/// per second, two for each.
double multiply_adds();

}  // namespace trajan::bench
