#pragma once

#include "solver/transfers/transfer_kernels.h"

/// Shape functions of particles that are parallelepipeds, kept as a table: 4^D weights and as many slopes
/// along each axis for every particle of a block.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Numbers of one particle's table.
constexpr std::ptrdiff_t corner_table(int axes) { return std::ptrdiff_t{1 + axes} << 2 * axes; }

template <Layout L>
struct CornerStencil {
  static constexpr int D = L.dimensions, rows = 1 << 2 * (L.dimensions - 1), together = 1;
  using Row = Four;

  __attribute__((always_inline)) CornerStencil(const RealScratch& s, RowParticles<1> of)
      : table_(s.stencils.data() + of.first * corner_table(D)) {}
  static constexpr int offset(int lane) { return lane; }
  __attribute__((always_inline)) static void add_row(double* to, Row row) { add(to, row); }
  template <class Function>
  __attribute__((always_inline)) void for_each_row(RowParticles<1>, Function&& of) const {
    constexpr std::ptrdiff_t quantity_size = 1 << 2 * D;
    const Real* weights = table_;
    for (int row = 0; row < rows; ++row, weights += 4) {
      Row slopes[D];
      for (int a = 0; a < D; ++a) slopes[a] = load<Row>(weights + (1 + a) * quantity_size);
      int at = 0;
      if constexpr (D > 1) at += row % 4 * L.window_stride(1);
      if constexpr (D > 2) at += row / 4 * L.window_stride(2);
      of(at, load<Row>(weights), slopes);
    }
  }

 private:
  const Real* table_;
};

/// Half the edges of a particle's parallelepiped, in cells: x = x_p + sum of edge[b] xi_b, |xi_b| <= 1.
/// Edges that would reach more than one cell from the particle are shortened, all alike (Homel, Brannon and
/// Guilkey 2016).
template <int D>
struct ParticleEdges {
  double along[D][D];  ///< [axis of space][edge]

  ParticleEdges(const Block& block, int i) {
    double longest = 0;
    for (int a = 0; a < D; ++a) {
      double reach = 0;
      for (int b = 0; b < D; ++b) {
        along[a][b] = static_cast<double>(deformation_of(block, a, b, i)) * block.body->half_size[b];
        reach += along[a][b] < 0 ? -along[a][b] : along[a][b];
      }
      longest = reach > longest ? reach : longest;
    }
    // Just under a cell, so that no corner reaches past the stencil.
    const double scale = longest > 0.999 ? 0.999 / longest : 1.0;
    for (auto& row : along)
      for (double& value : row) value *= scale;
  }

  /// Transposed inverse, [axis of space][edge].
  void inverse(double (&out)[D][D]) const {
    if constexpr (D == 1) {
      out[0][0] = 1 / along[0][0];
    } else if constexpr (D == 2) {
      const double q = 1 / (along[0][0] * along[1][1] - along[0][1] * along[1][0]);
      out[0][0] = q * along[1][1];
      out[0][1] = -q * along[1][0];
      out[1][0] = -q * along[0][1];
      out[1][1] = q * along[0][0];
    } else {
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          const int a1 = (a + 1) % 3, a2 = (a + 2) % 3, b1 = (b + 1) % 3, b2 = (b + 2) % 3;
          out[a][b] = along[a1][b1] * along[a2][b2] - along[a1][b2] * along[a2][b1];
        }
      const double q = 1 / (along[0][0] * out[0][0] + along[0][1] * out[0][1] + along[0][2] * out[0][2]);
      for (auto& row : out)
        for (double& value : row) value *= q;
    }
  }
};

/// The particle's functions are the means over its corners; their gradient is that of the interpolation between
/// the corners, averaged over the domain (Sadeghirad et al. 2011).
template <int D>
inline void tabulate(Block& block, int i) {
  constexpr int corners = 1 << D;
  constexpr std::ptrdiff_t quantity_size = 1 << 2 * D;
  Real* table = scratch_of(block).stencils.data() + i * corner_table(D);
  for (int k = 0; k < corner_table(D); ++k) table[k] = 0;
  const ParticleEdges<D> edges(block, i);
  double inverse[D][D];
  edges.inverse(inverse);
  for (int c = 0; c < corners; ++c) {
    double place[D], gradient[D] = {};
    int first = 0;
    for (int a = 0; a < D; ++a) {
      double at = scratch_of(block).place[a][i];
      for (int b = 0; b < D; ++b) {
        const double sign = c >> b & 1 ? 1.0 : -1.0;
        at += sign * edges.along[a][b];
        gradient[a] += sign * inverse[a][b] / corners;
      }
      const int node = static_cast<int>(at);
      place[a] = at - node;
      first += node << 2 * a;
    }
    for (int n = 0; n < corners; ++n) {
      double weight = 1;
      int at = first;
      for (int a = 0; a < D; ++a) {
        weight *= n >> a & 1 ? place[a] : 1 - place[a];
        at += (n >> a & 1) << 2 * a;
      }
      table[at] += Real(weight / corners);
      for (int a = 0; a < D; ++a) table[(1 + a) * quantity_size + at] += Real(weight * gradient[a]);
    }
  }
}

template <class Shape, Layout L>
inline void locate_corners(Block& block) {
  find_places<Shape, L>(block);
  find_runs(block);
  for (int i = 0; i < block.count; ++i) tabulate<L.dimensions>(block, i);
}
template <class Shape, Layout L>
inline constexpr TransferKernels corner_kernels_of = [] {
  TransferKernels kernels =
      transfer_kernels<Shape, L, CornerStencil<L>, &locate_corners<Shape, L>, &locate_corners<Shape, L>>;
  kernels.stencil_size = static_cast<int>(block_size * corner_table(L.dimensions));
  return kernels;
}();

template <class Shape>
requires(Shape::corners) struct TransferChoice<Shape> {
  static const TransferKernels* of(Dimension dimension, Margin) {
    return with_layout<Reach::wide, Margin::one_cell>(dimension,
                                                      []<Layout L>() { return &corner_kernels_of<Shape, L>; });
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
