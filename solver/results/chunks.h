#pragma once

#include <cstdint>

namespace trajan::results {

/// Particles of a snapshot that the result file keeps together, of all fields.
constexpr std::int64_t rows_per_chunk = 16384;

}  // namespace trajan::results
