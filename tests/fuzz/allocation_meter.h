#pragma once

#include <cstddef>

namespace trajan::testing {

/// Bytes that this thread has asked of operator new so far: a measure of work that, unlike time, is the
/// same on every machine. A program that links it gets its replacement of operator new.
std::size_t allocated_bytes();

}  // namespace trajan::testing
