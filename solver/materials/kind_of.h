#pragma once

#include <cmath>

#include "solver/materials/material.h"
#include "solver/materials/wave_modulus.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <AnyLaw Law>
double wave_speed_at_rest(std::span<const double> values, double density, Dimension dimension) {
  const Law law(values.data(), density);
  double modulus = 0;
  switch (dimension) {
    case Dimension::bar:
      modulus = wave_modulus_at_rest<Dimension::bar>(law);
      break;
    case Dimension::plane_stress:
      modulus = wave_modulus_at_rest<Dimension::plane_stress>(law);
      break;
    case Dimension::plane_strain:
      modulus = wave_modulus_at_rest<Dimension::plane_strain>(law);
      break;
    case Dimension::axisymmetric:
      modulus = wave_modulus_at_rest<Dimension::axisymmetric>(law);
      break;
    case Dimension::solid:
    case Dimension::unspecified:
      modulus = wave_modulus_at_rest<Dimension::solid>(law);
  }
  return std::sqrt(modulus / density);
}

/// The law's row in the registry.
template <AnyLaw Law>
MaterialKind kind_of() {
  MaterialKind kind{Law::name, Law::source, Law::rate_form, Law::parameters, {}, &wave_speed_at_rest<Law>, {},
                    {},        {}};
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
