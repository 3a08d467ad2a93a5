#pragma once

#include "solver/schemes/law_state.h"

/// What happens to deformation gradients and stresses whatever the law. Particles move by
/// x' = x + dt v(x), v being velocities of the middle of the step as a field over places at its beginning;
/// the gradient of just that map is 1 + dt L. It neither inflates nor shrinks what turns: the velocities of a
/// body that turns by R within a step are (R - 1) x / dt, hence 1 + dt L = R. (An exponential of dt L would be
/// right for L of the middle of the step, and shrink the body with this one.)
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// F' = (1 + dt L) F
template <Dimension D, bool RateForm>
TRAJAN_FLATTEN void deform_updated(Block& block) {
  constexpr int N = grid_axes(D);
  const DeformationArrays<N, stores_rest_stretch(D, RateForm)> deformation(block);
  const GradientArrays<D> gradient{*block.scratch};
  const double dt = deformation_time(block);
  std::int64_t inverted = 0;
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    const Tensor<N> f = deformation.at(i);
    const Tensor<N> next = fused(dt, product(gradient.at(i), f), f);
    deformation.set(i, next);
    inverted += !(determinant(next) > 0);
  }
  block.scratch->trouble.inverted += inverted;
}

/// F' = F + dt Fdot, which is exact; for a rate law, which sees to its volume itself, the
/// gradient becomes L = Fdot F^-1.
template <Dimension D, bool RateForm>
TRAJAN_FLATTEN void deform_total(Block& block) {
  constexpr int N = grid_axes(D);
  const DeformationArrays<N, stores_rest_stretch(D, RateForm)> deformation(block);
  const GradientArrays<D> gradient{*block.scratch};
  const double dt = deformation_time(block);
  std::int64_t inverted = 0;
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    const Tensor<N> f = deformation.at(i), rate = gradient.at(i);
    const Tensor<N> next = fused(dt, rate, f);
    deformation.set(i, next);
    if constexpr (RateForm) gradient.set(i, product(rate, inverse(f)));
    if constexpr (!RateForm) inverted += !(determinant(next) > 0);
  }
  block.scratch->trouble.inverted += inverted;
}

/// V sigma becomes V0 P = V sigma F^-T.
template <Dimension D, bool RateForm>
TRAJAN_FLATTEN void pull_back_force(Block& block) {
  constexpr int N = grid_axes(D);
  const DeformationArrays<N, stores_rest_stretch(D, RateForm)> deformation(block);
  Scratch& scratch = *block.scratch;
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    const Tensor<N> back = inverse(deformation.at(i));
    Tensor<N> force{};
    unroll<N * N>([&](auto k) { force(k / N, k % N) = scratch.force[k][i]; });
    if constexpr (D == Dimension::axisymmetric) force.diagonal[2] = scratch.virial_rest[i];
    const Tensor<N> nominal = product_transposed(force, back);
    unroll<N * N>([&](auto k) { scratch.force[k][i] = nominal(k / N, k % N); });
    if constexpr (D == Dimension::axisymmetric) scratch.virial_rest[i] = nominal.diagonal[2];
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
