#include "solver/results/fletcher32.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace trajan::results {

namespace {

/// So that the sums of a lane, at most 65535 longest (longest + 1) / 2, fit in 32 bits.
constexpr std::size_t longest = 360;

struct Sums {
  std::uint64_t plain = 0;     ///< of the words
  std::uint64_t weighted = 0;  ///< the first word as often as there are words, the last one once
};

/// Of `length` words in each lane, which lie by turns.
template <std::size_t lanes>
Sums sums_of_lanes(const std::byte* bytes, std::size_t length) {
  std::array<std::uint32_t, lanes> plain{}, weighted{};
  for (std::size_t i = 0; i < length; ++i) {
    std::array<std::uint16_t, lanes> words;
    std::memcpy(words.data(), bytes + i * sizeof(words), sizeof(words));
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      plain[lane] += words[lane];
      weighted[lane] += plain[lane];
    }
  }
  Sums sums;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    sums.plain += plain[lane];
    sums.weighted += lanes * std::uint64_t{weighted[lane]} - lane * std::uint64_t{plain[lane]};
  }
  return sums;
}

/// The remainder, but 65535 instead of 0 for what is not 0: so sums with end-around carry end.
std::uint32_t remainder(std::uint64_t sum) {
  return sum == 0 ? 0 : static_cast<std::uint32_t>((sum - 1) % 65535 + 1);
}

}  // namespace

std::uint32_t fletcher32(std::span<const std::byte> bytes) {
  constexpr std::size_t word = sizeof(std::uint16_t), lanes = 32;
  Sums sums;
  while (!bytes.empty()) {
    const bool whole = bytes.size() >= lanes * word;
    const std::size_t length = std::min(longest, bytes.size() / (whole ? lanes * word : word));
    const Sums next = whole ? sums_of_lanes<lanes>(bytes.data(), length) : sums_of_lanes<1>(bytes.data(), length);
    const std::size_t words = whole ? lanes * length : length;
    sums.weighted += words * sums.plain + next.weighted;
    sums.plain += next.plain;
    bytes = bytes.subspan(words * word);
  }
  // The filter takes the words as big-endian ones: to swap a word's bytes is to multiply it by 256, modulo 65535.
  return remainder(256 * remainder(sums.weighted)) << 16 | remainder(256 * remainder(sums.plain));
}

}  // namespace trajan::results
