#pragma once

#include "solver/transfers/strip_sums.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Lets the particles of a block that lie in strips give something to their nodes.
template <int Nodes, Layout L>
class StripScatter {
 public:
  explicit StripScatter(Block& block)
      : s_(scratch_of(block)),
        mass_{Real(block.body->mass), block[Attribute::reference_volume] ? s_.mass.values : nullptr} {
    if (mass_.of_particles)
      for (int i = 0; i < block.count; ++i) s_.mass[i] = Real(block.mass(i));
  }

  auto mass(double* to) const { return products(to, mass_); }
  /// A component of a vector of which `values` are the particles', times mass.
  auto momentum(double* to, const float* values) const {
    return products(
        to, [ mass = mass_, values ](const auto& strip)
                __attribute__((always_inline)) { return mass(strip) * strip.load(values); });
  }
  auto linear_momentum(double* to, const float* at_first, const float* moment_x, const float* moment_y,
                       float factor) const {
    return GivenLinearMomentum<Nodes, L, Mass>{{to}, mass_, at_first, moment_x, moment_y, factor};
  }
  /// `values` themselves.
  auto weighed(double* to, const float* values) const {
    return products(
        to, [values](const auto& strip) __attribute__((always_inline)) { return strip.load(values); });
  }
  auto force(double* to, const float* across_x, const float* across_y) const {
    return GivenForce<Nodes, L>{to, s_, across_x, across_y};
  }

  /// As many quantities at once as there are registers for their sums: of mass, momentum and force all five with
  /// 32, and with 16 the first three, which there takes 6 % off a step by MUSL with linear functions.
  template <class... Given>
  __attribute__((always_inline)) void give(const Given&... given) const {
    constexpr std::size_t together = Nodes == 2 ? register_count / 4 - 1 : 1;
    if constexpr (together == 1)
      (give_at_once(given), ...);
    else if constexpr (sizeof...(given) <= together)
      give_at_once(given...);
    else
      give_three(given...);
  }

 private:
  template <class First, class Second, class Third, class... Others>
  __attribute__((always_inline)) void give_three(const First& first, const Second& second, const Third& third,
                                                 const Others&... others) const {
    give_at_once(first, second, third);
    give(others...);
  }
  struct Mass {
    template <class OneStrip>
    __attribute__((always_inline)) Cells operator()(const OneStrip& strip) const {
      return of_particles ? strip.load(of_particles) : strip.only_there(spread<Cells>(of_each));
    }
    Real of_each;
    const Real* of_particles;
  };
  template <class Value>
  static auto products(double* to, Value value) {
    return GivenProducts<Nodes, L, Value>{{to}, value};
  }
  template <class... Given>
  __attribute__((always_inline)) void give_at_once(const Given&... given) const {
    give_of<SparseStrip>(given...);
    give_of<FullStrip>(given...);
  }
  template <class OneStrip, class... Given>
  __attribute__((always_inline)) void give_of(const Given&... given) const {
    for (int strip = 0; strip < OneStrip::list(s_).size;) strip = give_rows<OneStrip>(strip, given...);
  }
  /// From a strip on, in groups of strips that have the same lanes, as many as follow each other row by row.
  /// Returns the strip after them.
  template <class OneStrip, class... Sums>
  __attribute__((always_inline)) int give_rows(int i, Sums... sums) const {
    const auto& list = OneStrip::list(s_);
    for (;;) {
      const int cell = list.cell[i];
      do {
        const OneStrip strip(s_, i);
        const AlongAxis<Nodes> x(s_, 0, strip), y(s_, 1, strip);
        (sums.add(strip, x, y), ...);
      } while (++i < list.size && list.cell[i] == cell);
      if (i == list.size || list.cell[i] != cell + L.window_stride(1)) {
        (sums.finish(cell), ...);
        return i;
      }
      (sums.go_on(cell), ...);
    }
  }

  RealScratch& s_;
  Mass mass_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
