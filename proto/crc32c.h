#pragma once

#include <nmmintrin.h>

#include <cstdint>
#include <cstring>
#include <string_view>

namespace trajan {

/// CRC-32C (Castagnoli; RFC 3720, appendix B.4) of `data`, as in `ReadResultResponse`. Both ends of the
/// API need it. Uses the processor's instruction, which every x86-64-v2 has.
inline std::uint32_t crc32c(std::string_view data) {
  std::uint64_t crc = 0xFFFFFFFF;
  const char* at = data.data();
  std::size_t left = data.size();
  for (; left >= sizeof(std::uint64_t); at += sizeof(std::uint64_t), left -= sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, at, sizeof word);
    crc = _mm_crc32_u64(crc, word);
  }
  auto crc32 = static_cast<std::uint32_t>(crc);
  for (; left > 0; ++at, --left) crc32 = _mm_crc32_u8(crc32, static_cast<unsigned char>(*at));
  return ~crc32;
}

}  // namespace trajan
