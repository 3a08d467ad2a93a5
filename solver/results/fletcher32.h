#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace trajan::results {

/// Fletcher's checksum (J. G. Fletcher, An arithmetic checksum for serial transmissions, IEEE Trans. Comm. 30,
/// 1982) of 16-bit words, modulo 65535, as HDF5's filter stores it after a chunk. An even number of bytes.
std::uint32_t fletcher32(std::span<const std::byte> bytes);

}  // namespace trajan::results
