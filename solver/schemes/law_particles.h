#pragma once

#include "solver/schemes/law_state.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The particles of a block as the law sees them. Unlike: in any dimension they may differ in reference volume.
template <class Law, Dimension D, bool Unlike = false>
struct LawParticles {
  static constexpr int N = grid_axes(D), history_size = history_count<Law>();
  using State = RateState<N, double, history_size>;

  DeformationArrays<N, stores_rest_stretch(D, Law::rate_form)> deformation;
  StressArrays<N, !rest_is_free(D)> stress;
  HistoryArrays<history_size> history;
  double* volume;
  const double* reference_volumes;
  double common_volume, density;

  explicit LawParticles(const Block& b)
      : deformation(b),
        stress(b),
        history(b),
        volume(b[Attribute::volume]),
        reference_volumes(b[Attribute::reference_volume]),
        common_volume(b.body->reference_volume),
        density(b.body->density) {}
  double reference_volume(int i) const {
    if constexpr (D == Dimension::axisymmetric)
      return reference_volumes[i];
    else if constexpr (Unlike)
      return reference_volumes ? reference_volumes[i] : common_volume;
    else
      return common_volume;
  }
  State state(int i) const { return {stress.at(i), volume[i] * (1 / reference_volume(i)), history.at(i)}; }
  /// Volume times Kirchhoff or Cauchy stress, whichever makes it the particle's virial.
  SymmetricTensor<N> virial(const Law& law, int i) const {
    if constexpr (Law::rate_form)
      return volume[i] * cauchy_stress(law, state(i));
    else
      return reference_volume(i) * respond(law, deformation.at(i), history.at(i)).kirchhoff;
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
