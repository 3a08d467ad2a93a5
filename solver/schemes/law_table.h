#pragma once

#include <vector>

#include "solver/schemes/law_deform.h"
#include "solver/schemes/law_floats.h"

/// The tables of a law's stages, one for each dimension and configuration.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <class Law, Dimension D, bool TotalLagrangian>
constexpr Stage deform_stage() {
  if constexpr (Law::rate_form) {
    return TotalLagrangian ? &in_turn<&deform_total<D, true>, &advance<Law, D>> : &advance<Law, D>;
  } else {
    constexpr Stage follow = TotalLagrangian ? &deform_total<D, false> : &deform_updated<D, false>;
    if constexpr (rest_is_free(D) || history_count<Law>() > 0)
      return &in_turn<follow, &settle<Law, D>>;
    else
      return follow;
  }
}

template <class Law, Dimension D, bool TotalLagrangian>
constexpr LawKernels::InFloats float_stages() {
  if constexpr (is_computed_in_floats<Law, D, TotalLagrangian>())
    return {&FloatStages<Law, D, TotalLagrangian>::force, &FloatStages<Law, D, TotalLagrangian>::deform};
  else
    return {};
}

/// The attributes of a deformation gradient, after others.
template <Dimension D, bool RateForm>
std::vector<Attribute> deformation_gradient(std::vector<Attribute> attributes = {}) {
  constexpr int N = grid_axes(D);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if ((i < N && j < N) || (i == j && stores_rest_stretch(D, RateForm)))
        attributes.push_back(deformation_attribute(i, j));
  return attributes;
}

/// What particles carry for a law: in a finite law F, in a rate law stress and volume, and F too if the scheme
/// is total Lagrangian.
template <class Law, Dimension D, bool TotalLagrangian>
std::vector<Attribute> carried() {
  constexpr int N = grid_axes(D);
  std::vector<Attribute> carried;
  if (Law::rate_form) {
    carried.push_back(Attribute::volume);
    for (int k = 0; k < (rest_is_free(D) ? N : 3); ++k) carried.push_back(after(Attribute::stress_xx, k));
    for (int k = 0; k < SymmetricTensor<N>::off_count; ++k) carried.push_back(after(Attribute::stress_xy, k));
  }
  if (!Law::rate_form || TotalLagrangian) carried = deformation_gradient<D, Law::rate_form>(std::move(carried));
  for (int h = 0; h < history_count<Law>(); ++h) carried.push_back(after(Attribute::history_0, h));
  return carried;
}

template <class Law>
std::unique_ptr<const void, void (*)(const void*)> make_law(const double* parameters, double density) {
  return {new Law(parameters, density), [](const void* made) { delete static_cast<const Law*>(made); }};
}

template <class Law>
void begin_history(const void* law, std::uint64_t particle, double* history) {
  const HistoryOf<Law> initial = initial_history(*static_cast<const Law*>(law), particle);
  std::copy(initial.begin(), initial.end(), history);
}

template <class Law, Dimension D, bool TotalLagrangian>
const LawKernels* table() {
  using Stages = LawStages<Law, D>;
  constexpr bool pulls_back = TotalLagrangian && !is_geometrically_linear<Law>();
  constexpr Stage force =
      pulls_back ? &in_turn<&Stages::force, &pull_back_force<D, Law::rate_form>> : &Stages::force;
  static const std::vector<Attribute> attributes = carried<Law, D, TotalLagrangian>();
  constexpr bool tracks = Law::rate_form && !TotalLagrangian;
  static const std::vector<Attribute> tracked =
      tracks ? deformation_gradient<D, Law::rate_form>() : std::vector<Attribute>();
  static const LawKernels kernels{&make_law<Law>,
                                  &begin_history<Law>,
                                  attributes,
                                  history_count<Law>(),
                                  Law::rate_form,
                                  force,
                                  deform_stage<Law, D, TotalLagrangian>(),
                                  tracks ? &deform_updated<D, Law::rate_form> : nullptr,
                                  tracked,
                                  &Stages::stress,
                                  &Stages::template measure<TotalLagrangian>,
                                  float_stages<Law, D, TotalLagrangian>()};
  return &kernels;
}

template <class Law>
const LawKernels* table_of(Dimension dimension, bool total_lagrangian) {
  switch (dimension) {
#define TRAJAN_TABLE(D) \
  case Dimension::D:    \
    return total_lagrangian ? table<Law, Dimension::D, true>() : table<Law, Dimension::D, false>();
    TRAJAN_TABLE(bar)
    TRAJAN_TABLE(plane_stress)
    TRAJAN_TABLE(plane_strain)
    TRAJAN_TABLE(axisymmetric)
    TRAJAN_TABLE(solid)
#undef TRAJAN_TABLE
    case Dimension::unspecified:
      break;
  }
  return nullptr;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
