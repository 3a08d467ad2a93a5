#pragma once

#include <cstdint>
#include <utility>

#include "solver/transfers/intrinsics.h"

/// Where sequences of numbers end.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Where numbers change.
struct Changes {
  template <class Number>
  static auto is_end(Number before, Number now) {
    return now != before;
  }
};

/// Where numbers of `row` rows of as many do not grow, or come to another row.
template <std::int32_t row>
struct RiseEnds {
  template <class Number>
  static auto is_end(Number before, Number now) {
    return (now <= before) | (row_of(now) != row_of(before));
  }
  template <class Number>
  static Number row_of(Number number) {
    return number * factor >> 16;
  }
  static constexpr std::int32_t factor = (1 << 16) / row + 1;
  static_assert((row * row - 1) * factor >> 16 == row - 1 && row * (row - 1) * factor >> 16 == row - 1);
};

/// The numbers before each of `now`, of which the first one's is the last one of `last`.
template <std::size_t... place>
__attribute__((always_inline)) inline intrinsics::Places ones_before(intrinsics::Places last,
                                                                     intrinsics::Places now,
                                                                     std::index_sequence<place...>) {
  return __builtin_shufflevector(last, now, (sizeof...(place) - 1 + place)...);
}

/// Writes the indices i in 1 .. count - 1 for which At::is_end(values[i - 1], values[i]), in order, and returns
/// how many there are. Without a branch that depends on the values, and with room for 16 indices more. Each number
/// is read once: what has just been written and is then read from another address has to wait for the cache.
template <class At>
inline int find_ends(const std::int32_t* values, int count, std::int32_t* out) {
  int found = 0;
  if constexpr (intrinsics::has_places) {
    using intrinsics::Places;
    constexpr int places = sizeof(Places) / sizeof(std::int32_t);
    Places last = Places{} + values[0];
    for (int i = 0; i < count; i += places) {
      const unsigned there = count - i < places ? (1U << (count - i)) - 1 : (1U << places) - 1;
      const Places now = intrinsics::load_places(values + i, there);
      const Places before = ones_before(last, now, std::make_index_sequence<places>());
      const unsigned after_the_first = i > 0 ? there : there & ~1U;
      const unsigned ends = intrinsics::negative_places(At::is_end(before, now)) & after_the_first;
      intrinsics::store_places(out + found, ends, i);
      found += __builtin_popcount(ends);
      last = now;
    }
  } else {
    for (int i = 1; i < count; ++i) {
      out[found] = i;
      found += At::is_end(values[i - 1], values[i]);
    }
  }
  return found;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
