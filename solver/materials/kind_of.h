#pragma once

#include <cmath>

#include "solver/materials/acoustic_tensor.h"
#include "solver/materials/material.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// of(d) with d() the dimension, known when it is compiled; solid if it is not specified.
template <class Of>
auto in_dimension(Dimension dimension, Of&& of) {
  switch (dimension) {
    case Dimension::bar:
      return of(std::integral_constant<Dimension, Dimension::bar>());
    case Dimension::plane_stress:
      return of(std::integral_constant<Dimension, Dimension::plane_stress>());
    case Dimension::plane_strain:
      return of(std::integral_constant<Dimension, Dimension::plane_strain>());
    case Dimension::axisymmetric:
      return of(std::integral_constant<Dimension, Dimension::axisymmetric>());
    default:
      return of(std::integral_constant<Dimension, Dimension::solid>());
  }
}

template <AnyLaw Law>
double wave_speed_at_rest(std::span<const double> values, double density, Dimension dimension) {
  const Law law(values.data(), density);
  const double modulus = in_dimension(dimension, [&](auto d) { return wave_modulus_at_rest<d()>(law); });
  return std::sqrt(modulus / density);
}

template <AnyLaw Law>
void acoustic_tensor(std::span<const double> values, double density, Dimension dimension, int axis,
                     std::span<double> out) {
  const Law law(values.data(), density);
  in_dimension(dimension, [&](auto d) { acoustic_tensor_at_rest<d()>(law, axis, out); });
}

/// The law's row in the registry.
template <AnyLaw Law>
MaterialKind kind_of() {
  MaterialKind kind{Law::name,
                    Law::source,
                    Law::rate_form,
                    Law::parameters,
                    {},
                    &wave_speed_at_rest<Law>,
                    &acoustic_tensor<Law>,
                    {},
                    {},
                    {}};
  if constexpr (requires { Law::history; }) kind.history = Law::history;
  if constexpr (requires(const Law& law) { law.diffusivity(); })
    kind.diffusivity = [](std::span<const double> values, double density) {
      return Law(values.data(), density).diffusivity();
    };
  kind.check = [](std::span<const double> values, Dimension dimension) {
    if constexpr (requires { Law::check(values.data(), dimension); })
      return Law::check(values.data(), dimension);
    else
      return static_cast<void>(values), static_cast<void>(dimension), Objection{};
  };
  kind.objection = [](Dimension dimension, bool total_lagrangian) {
    if constexpr (requires { Law::objection(dimension, total_lagrangian); })
      return Law::objection(dimension, total_lagrangian);
    else
      return static_cast<void>(dimension), static_cast<void>(total_lagrangian), std::string_view{};
  };
  return kind;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
