#pragma once

#include "solver/transfers/registers.h"

/// Some lanes of vectors.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// from[first] .. from[end - 1] in the lanes that they have in a vector that begins at `from`, zeros in the
/// others. One instruction instead of one or two a lane: in space with linear functions and floats what nodes
/// collect takes 12 instead of 17 % of a step.
template <class Vector, int first, int end>
__attribute__((always_inline)) inline Vector load_lanes(const double* from) {
  Vector lanes{};
  if constexpr (is_twice<Vector>) {
    constexpr int half = Vector::half;
    constexpr auto clipped = [](int lane) { return lane < 0 ? 0 : lane < half ? lane : half; };
    using Half = decltype(Vector::lower);
    lanes.lower = load_lanes<Half, clipped(first), clipped(end)>(from);
    lanes.upper = load_lanes<Half, clipped(first - half), clipped(end - half)>(from + half);
  } else if constexpr (requires { intrinsics::load_masked(from, 0, lanes); }) {
    intrinsics::load_masked(from, (1LL << end) - (1LL << first), lanes);
  } else {
#pragma GCC unroll 8
    for (int lane = first; lane < end; ++lane) lanes[lane] = from[lane];
  }
  return lanes;
}

/// The lanes of a vector from one on.
template <class Vector>
struct LanesFrom {
  using Index = std::conditional_t<sizeof(std::declval<Vector&>()[0]) == 8, std::int64_t, std::int32_t>;
  static constexpr int lanes = sizeof(Vector) / sizeof(Index);
  using Indices = typename VectorOf<Index, static_cast<std::size_t>(lanes)>::Type;

  explicit LanesFrom(int first = 0) {
#pragma GCC unroll 16
    for (int lane = 0; lane < lanes; ++lane) mask[lane] = lane >= first ? -1 : 0;
  }
  /// Puts a number in these lanes.
  template <class Number>
  __attribute__((always_inline)) Vector put(const Number* number, Vector into) const {
    return mask ? *number - Vector{} : into;
  }

  Indices mask;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
