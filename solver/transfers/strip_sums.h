#pragma once

#include "solver/transfers/strip_nodes.h"

/// What particles in strips give to nodes, before these get it.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// \name What strips give to their nodes
/// Each is added up for all strips of a group before nodes get it: by `finish`, or by `go_on` if the next
/// group has the same lanes in the next row of cells, with which it shares all nodes but those of one row.
/// `to`: sums of a quantity.
/// @{

/// Sums of the nodes alone.
template <int Nodes, Layout L>
struct GivenToNodes {
  __attribute__((always_inline)) void go_on(std::int32_t cell) { sums.add_first_row(to + cell); }
  __attribute__((always_inline)) void finish(std::int32_t cell) const { sums.add_to(to + cell); }

  double* to;
  NodesOfStrips<Nodes, L> sums{};
};

/// Of numbers, each strip's by `Value`, times weights.
template <int Nodes, Layout L, class Value>
struct GivenProducts : GivenToNodes<Nodes, L> {
  template <class OneStrip>
  __attribute__((always_inline)) void add(const OneStrip& strip, const AlongAxis<Nodes>& x,
                                          const AlongAxis<Nodes>& y) {
    const Cells value = value_of(strip);
#pragma GCC unroll 4
    for (int j = 0; j < Nodes; ++j) {
      const Cells row = y.weight[j] * value;
#pragma GCC unroll 4
      for (int i = 0; i < Nodes; ++i) {
        Cells& sum = this->sums.node[j][i];
        sum = multiply_add(x.weight[i], row, sum);
      }
    }
  }

  Value value_of;
};

/// A component of internal forces, of the parts that act across both axes.
template <int Nodes, Layout L>
struct GivenForce {
  template <class OneStrip>
  __attribute__((always_inline)) void add(const OneStrip& strip, const AlongAxis<Nodes>& x,
                                          const AlongAxis<Nodes>& y) {
    const Cells fx = strip.load(across_x), fy = strip.load(across_y);
    if constexpr (Nodes == 2) {
      // Slopes along one axis are weights along the other.
#pragma GCC unroll 2
      for (int n = 0; n < 2; ++n) {
        along_x[n] = multiply_add(y.weight[n], fx, along_x[n]);
        along_y[n] = multiply_add(x.weight[n], fy, along_y[n]);
      }
    } else {
      Cells slope_x[Nodes];
#pragma GCC unroll 4
      for (int i = 0; i < Nodes; ++i) slope_x[i] = strip.load(scratch.slope[0][i].values);
#pragma GCC unroll 4
      for (int j = 0; j < Nodes; ++j) {
        const Cells row_x = y.weight[j] * -fx, row_y = strip.load(scratch.slope[1][j].values) * -fy;
#pragma GCC unroll 4
        for (int i = 0; i < Nodes; ++i)
          sums.node[j][i] = multiply_add(slope_x[i], row_x, multiply_add(x.weight[i], row_y, sums.node[j][i]));
      }
    }
  }
  __attribute__((always_inline)) void go_on(std::int32_t cell) {
    to_nodes();
    sums.add_first_row(to + cell);
  }
  __attribute__((always_inline)) void finish(std::int32_t cell) {
    to_nodes();
    sums.add_to(to + cell);
  }
  /// What has been added up by axis.
  __attribute__((always_inline)) void to_nodes() {
    if constexpr (Nodes == 2) {
      sums.node[0][0] += along_x[0] + along_y[0], sums.node[0][1] += along_y[1] - along_x[0];
      sums.node[1][0] += along_x[1] - along_y[0], sums.node[1][1] -= along_x[1] + along_y[1];
      along_x[0] = along_x[1] = along_y[0] = along_y[1] = Cells{};
    }
  }

  double* to;
  const RealScratch& scratch;
  const float *across_x, *across_y;
  NodesOfStrips<Nodes, L> sums{};
  Cells along_x[2]{}, along_y[2]{};
};

/// Of a velocity that is `at_first` at a particle's first node and grows by `factor` times moments from one node
/// to the next: momentum.
template <int Nodes, Layout L, class Mass>
struct GivenLinearMomentum : GivenToNodes<Nodes, L> {
  template <class OneStrip>
  __attribute__((always_inline)) void add(const OneStrip& strip, const AlongAxis<Nodes>& x,
                                          const AlongAxis<Nodes>& y) {
    const Cells mass = mass_of(strip), along_x = factor * strip.load(moment_x),
                along_y = factor * strip.load(moment_y);
    Cells velocity = strip.load(at_first);
#pragma GCC unroll 4
    for (int j = 0; j < Nodes; ++j, velocity += along_y) {
      const Cells of_row = y.weight[j] * mass, row = of_row * velocity, change = of_row * along_x;
#pragma GCC unroll 4
      for (int i = 0; i < Nodes; ++i) {
        Cells& sum = this->sums.node[j][i];
        sum = multiply_add(x.weight[i], multiply_add(spread<Cells>(float(i)), change, row), sum);
      }
    }
  }

  Mass mass_of;
  const float *at_first, *moment_x, *moment_y;
  float factor;
};
/// @}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
