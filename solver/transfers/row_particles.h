#pragma once

#include <bit>
#include <concepts>
#include <cstdint>

#include "solver/transfers/real.h"
#include "solver/transfers/vectors.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Consecutive particles that give to a row of nodes at the same time: their numbers take turns in its lanes. One,
/// or two of which the second may not exist (`count`), whose numbers are zero then.
template <int places, int count = places>
struct RowParticles {
  static constexpr bool is_one = places == 1;

  /// Which node of a row a lane is.
  template <class Row>
  __attribute__((always_inline)) static Row node_numbers() {
    Row numbers;
#pragma GCC unroll 8
    for (int lane = 0; lane < static_cast<int>(sizeof(Row) / sizeof(Real)); ++lane) {
      const int node = lane / places;
      numbers[lane] = Real(node);
    }
    return numbers;
  }
  /// Of a row, over the particles.
  template <class Row>
  __attribute__((always_inline)) static Four sum(Row row) {
    if constexpr (is_one)
      return row;
    else
      return sum_of_pairs(row);
  }

  /// What a row is multiplied by: values[i] of particle i, or of(i).
  template <class Row>
  __attribute__((always_inline)) auto factor(const Real* values) const {
    if constexpr (is_one)
      return values[first];
    else
      return in_turns<Row>(pair(values));
  }
  template <class Row, std::invocable<int> Of>
  __attribute__((always_inline)) auto factor(Of&& of) const {
    if constexpr (is_one)
      return of(first);
    else
      return in_turns<Row>(pair(of));
  }
  /// The same in all lanes.
  template <class Row>
  __attribute__((always_inline)) Row each(const Real* values) const {
    return spread<Row>(factor<Row>(values));
  }
  /// values[n][i] in the lane of node n and particle i; past so many nodes zero.
  template <class Row>
  __attribute__((always_inline)) Row row(const RealArray* values, int nodes) const {
    if constexpr (is_one) {
      Row r{};
      for (int n = 0; n < nodes; ++n) r[n] = values[n].values[first];
      return r;
    } else {
      Pairs<Row> r{};
      for (int n = 0; n < nodes; ++n) r[n] = pair(values[n].values);
      return std::bit_cast<Row>(r);
    }
  }

  int first;

 private:
  /// Two floats as one number: GCC 12 puts vectors as short as that together lane by lane.
  using TwoFloats = std::int64_t;
  template <class Row>
  using Pairs = typename VectorOf<TwoFloats, sizeof(Row) / sizeof(TwoFloats)>::Type;

  template <std::invocable<int> Of>
  __attribute__((always_inline)) TwoFloats pair(Of&& of) const {
    using Numbers = typename VectorOf<Real, places>::Type;
    return std::bit_cast<TwoFloats>(Numbers{of(first), count > 1 ? of(first + 1) : Real(0)});
  }
  __attribute__((always_inline)) TwoFloats pair(const Real* values) const {
    if constexpr (count > 1)
      return load<TwoFloats>(values + first);
    else
      return pair([values](int i) __attribute__((always_inline)) { return values[i]; });
  }
  template <class Row>
  __attribute__((always_inline)) static Row in_turns(TwoFloats two) {
    return std::bit_cast<Row>(spread<Pairs<Row>>(two));
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
