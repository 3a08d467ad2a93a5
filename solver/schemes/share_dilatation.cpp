#include "solver/schemes/share_dilatation.h"

#include <array>
#include <bit>

#include "solver/materials/material.h"
#include "solver/schemes/law_response.h"
#include "solver/schemes/law_state.h"
#include "solver/schemes/volume_sharing.h"

namespace trajan {
namespace {

/// What a law shares: the trace of its strains, or the volume ratio of a step or since rest.
enum class Shares { trace, step, total };

/// Mean over the particles of a block that have the same number.
class CellMeans {
 public:
  explicit CellMeans(const Block& block) : cells_(block.scratch->cell) {}

  void add(int i, double weight, double value) {
    Sum& sum = find(cells_[i]);
    sum.weight += weight;
    sum.value += weight * value;
  }
  double operator()(int i) {
    const Sum& sum = find(cells_[i]);
    return sum.value / sum.weight;
  }

 private:
  struct Sum {
    std::int32_t cell = -1;
    double weight = 0, value = 0;
  };
  static constexpr std::size_t slots = std::bit_ceil(2U * block_size);  // never full

  Sum& find(std::int32_t cell) {
    for (std::size_t slot = static_cast<std::size_t>(cell) % slots;; slot = (slot + 1) % slots) {
      if (sums_[slot].cell < 0) sums_[slot].cell = cell;
      if (sums_[slot].cell == cell) return sums_[slot];
    }
  }

  const std::int32_t* cells_;
  std::array<Sum, slots> sums_{};
};

template <Dimension D, Shares shares>
void share(Block& block) {
  using Sharing = VolumeSharing<D>;
  constexpr int N = Sharing::N;
  const double dt = deformation_time(block);
  if (!(dt > 0)) return;
  const Sharing sharing{shares == Shares::trace, 1};
  const GradientArrays<D> gradients{*block.scratch};
  const DeformationArrays<N, D == Dimension::axisymmetric> deformation(block);
  double* const volumes = block[Attribute::volume];
  const auto one = identity<N>();
  CellMeans means(block);
  std::array<Tensor<N>, block_size> ends;
  for (int i = 0; i < block.count; ++i) {
    const Tensor<N> change = dt * gradients.at(i);
    if constexpr (shares == Shares::total) {
      // The gradient that it has had itself: the law stores the one that it has felt.
      const double at_rest = block.mass(i) / block.body->density;
      ends[i] = sharing.felt(deformation.at(i), volumes[i] / at_rest) + change;
      volumes[i] = sharing.ratio(ends[i]) * at_rest;
    } else if constexpr (shares == Shares::step) {
      ends[i] = one + product(change, inverse(deformation.at(i)));
    } else {
      ends[i] = one + change;
    }
    means.add(i, block.mass(i), sharing.ratio(ends[i]));
  }
  for (int i = 0; i < block.count; ++i) {
    const double ratio = sharing.ratio(ends[i]), mean = means(i);
    // What is turned inside out is left to the law to be found.
    const Tensor<N> felt = ratio > 0 && mean > 0 ? sharing.felt(ends[i], mean) : ends[i];
    if constexpr (shares == Shares::total)
      gradients.set(i, (1 / dt) * (felt - deformation.at(i)));
    else if constexpr (shares == Shares::step)
      gradients.set(i, product((1 / dt) * (felt - one), deformation.at(i)));
    else
      gradients.set(i, (1 / dt) * (felt - one));
  }
}

template <Shares shares>
Stage stage_of(Dimension dimension) {
  Stage stage = nullptr;
  in_volume_dimension(dimension, [&]<Dimension D>() { stage = &share<D, shares>; });
  return stage;
}

}  // namespace

Stage share_dilatation(std::string_view law, Dimension dimension) {
  if (law_response(law, dimension, true)->geometrically_linear) return stage_of<Shares::trace>(dimension);
  return find_material_kind(law)->rate_form ? stage_of<Shares::step>(dimension)
                                            : stage_of<Shares::total>(dimension);
}

}  // namespace trajan
