#pragma once

#include "solver/transfers/masks.h"
#include "solver/transfers/stencil.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// As many particles as are handled at once, each a lane. Registers of AVX-512 hold twice as many, but only where
/// cells have eight particles, and stencils two nodes along an axis, is it worth that: linear functions in space
/// take 3 % less of a step, quadratic B-splines a tenth more (Zen 4).
template <int nodes, int axes>
struct LanesFor {
#ifdef __AVX512F__
  static constexpr int count = nodes == 2 && axes == 3 ? 8 : 32 / sizeof(Real);
#else
  static constexpr int count = 32 / sizeof(Real);
#endif
  // Arrays of a block have room for the lanes past its last particle.
  static_assert(count <= 2 * block_padding);
  using Type = typename VectorOf<Real, count>::Type;
};

/// What the nodes of several particles hold, the particles of each of so many runs a range of lanes: with four
/// particles to a cell one run alone would leave half of eight lanes empty.
template <class Lanes, int Runs>
class NodesOfRuns {
 public:
  /// Of the particles from the first one of a run on.
  NodesOfRuns(const RealScratch& s, int run, const Real* window) {
    const int begin = s.run_begin[run], last = s.runs - 1;
#pragma GCC unroll 4
    for (int r = 0; r < Runs; ++r) {
      const int first = s.run_begin[run + r < last ? run + r : last];
      from_[r] = hidden(window + s.cell[first]);
      if (r > 0) lanes_[r - 1] = LanesFrom<Lanes>(first - begin);
    }
  }
  __attribute__((always_inline)) Lanes operator[](int node) const {
    auto values = spread<Lanes>(from_[0][node]);
#pragma GCC unroll 4
    for (int r = 1; r < Runs; ++r) values = lanes_[r - 1].put(from_[r] + node, values);
    return values;
  }

 private:
  const Real* from_[Runs];
  LanesFrom<Lanes> lanes_[Runs];
};

/// Several particles at once, each a lane: consecutive ones, or those of a strip.
template <int Nodes, Layout L, class Slopes = ShapeSlopes>
struct ProductLanes {
  static constexpr int D = L.dimensions;
  static constexpr int lanes = LanesFor<Nodes, D>::count;
  using Lanes = typename LanesFor<Nodes, D>::Type;

  template <class Particles>
  __attribute__((always_inline)) ProductLanes(const RealScratch& s, const Particles& particles) {
#pragma GCC unroll 3
    for (int axis = 0; axis < D; ++axis)
#pragma GCC unroll 4
      for (int n = 0; n < Nodes; ++n) {
        weight_[axis][n] = particles.load(s.weight[axis][n].values);
        slope_[axis][n] = Slopes::lanes(s, axis, n, particles);
      }
  }

  /// sums[0]: of what the nodes hold, counted from `from`, times their weights; sums[1 + axis]: times slopes along
  /// it.
  template <int Axes = D, class NodeValues>
  __attribute__((always_inline)) void contract(const NodeValues& nodes, int from, Lanes (&sums)[1 + Axes]) const {
    constexpr int axis = Axes - 1;
#pragma GCC unroll 4
    for (int n = 0; n < Nodes; ++n) {
      if constexpr (axis == 0) {
        const Lanes node = nodes[from + n];
        sums[0] = n == 0 ? weight_[0][n] * node : multiply_add(weight_[0][n], node, sums[0]);
        sums[1] = n == 0 ? slope_[0][n] * node : multiply_add(slope_[0][n], node, sums[1]);
      } else {
        Lanes inner[Axes];
        contract<axis>(nodes, from + n * L.window_stride(axis), inner);
#pragma GCC unroll 3
        for (int s = 0; s < Axes; ++s)
          sums[s] = n == 0 ? weight_[axis][n] * inner[s] : multiply_add(weight_[axis][n], inner[s], sums[s]);
        sums[Axes] = n == 0 ? slope_[axis][n] * inner[0] : multiply_add(slope_[axis][n], inner[0], sums[Axes]);
      }
    }
  }

 private:
  Lanes weight_[D][Nodes], slope_[D][Nodes];
};

/// Two nodes along each axis: the weights are 1 - p and p, the slopes -1 and 1.
template <Layout L>
struct ProductLanes<2, L, ShapeSlopes> {
  static constexpr int D = L.dimensions;
  static constexpr int lanes = LanesFor<2, D>::count;
  using Lanes = typename LanesFor<2, D>::Type;

  template <class Particles>
  __attribute__((always_inline)) ProductLanes(const RealScratch& s, const Particles& particles) {
#pragma GCC unroll 3
    for (int axis = 0; axis < D; ++axis) {
      upper_[axis] = particles.load(s.place[axis].values);
      lower_[axis] = 1 - upper_[axis];
    }
  }

  template <int Axes = D, class NodeValues>
  __attribute__((always_inline)) void contract(const NodeValues& nodes, int from, Lanes (&sums)[1 + Axes]) const {
    constexpr int axis = Axes - 1;
    if constexpr (axis == 0) {
      const Lanes left = nodes[from], right = nodes[from + 1];
      sums[0] = multiply_add(upper_[0], right, lower_[0] * left);
      sums[1] = right - left;
    } else {
      Lanes below[Axes], above[Axes];
      contract<axis>(nodes, from, below);
      contract<axis>(nodes, from + L.window_stride(axis), above);
#pragma GCC unroll 3
      for (int s = 0; s < Axes; ++s) sums[s] = multiply_add(upper_[axis], above[s], lower_[axis] * below[s]);
      sums[Axes] = above[0] - below[0];
    }
  }

 private:
  Lanes lower_[D], upper_[D];
};

template <class Stencil>
struct LanesOf {
  static constexpr bool exist = false;
};
template <int Nodes, Layout L, class Slopes>
struct LanesOf<ProductStencil<Nodes, L, Slopes>> {
  static constexpr bool exist = true;
  using Type = ProductLanes<Nodes, L, Slopes>;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
