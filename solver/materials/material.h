#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "solver/scene/scene.h"

namespace trajan {

/// What an optional parameter is that has no natural default and was not given.
inline constexpr double not_given = 1e299;

/// One row of a law's own parameter table. Validation, error messages and documentation read it.
struct Parameter {
  std::string_view name;  ///< as in materials.proto
  std::string_view unit;  ///< "stress", "1", …
  std::string_view meaning;
  double lowest;   ///< open bound: the value must be greater
  double highest;  ///< open bound: the value must be less
  /// What it is if it is not given; not a number: it must be given.
  double otherwise = std::numeric_limits<double>::quiet_NaN();
  bool lowest_allowed = false;  ///< the lowest value itself is in range
  bool highest_allowed = false;

  bool optional() const { return !std::isnan(otherwise); }
  bool allows(double value) const {
    return std::isfinite(value) && (value > lowest || (lowest_allowed && value == lowest)) &&
           (value < highest || (highest_allowed && value == highest));
  }
};

/// One of the numbers that a law remembers at a particle.
struct HistoryVariable {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  double initial;
};

/// What is wrong with a law's parameters together, and what would be right. Empty: nothing.
struct Objection {
  std::string problem;
  std::string remedy;
};

/// What the rest of the solver knows of a constitutive law without knowing its formulas.
/// Values of parameters are always passed in the order of `parameters`.
struct MaterialKind {
  std::string_view name;  ///< as in materials.proto, for example "linear_elastic"
  std::string_view source;
  bool rate_form;  ///< the state is a stress; otherwise a deformation gradient
  std::span<const Parameter> parameters;
  std::span<const HistoryVariable> history;  ///< what particles of the material remember
  /// Speed of the fastest wave at rest (consistent units) for a mass density at rest.
  double (*wave_speed)(std::span<const double> values, double density, Dimension dimension);
  /// The acoustic tensor at rest for waves along a grid axis, axes x axes: traction on a plane normal to the axis
  /// by the gradient of displacement along it.
  void (*acoustic_tensor)(std::span<const double> values, double density, Dimension dimension, int axis,
                          std::span<double> out);
  /// By which momentum diffuses, length^2 per time; nullptr: it does not.
  double (*diffusivity)(std::span<const double> values, double density);
  /// What is wrong with values that are each in their range.
  Objection (*check)(std::span<const double> values, Dimension dimension);
  /// Why the law must not be used in scenes of this kind; empty: it may.
  std::string_view (*objection)(Dimension dimension, bool total_lagrangian);
};

/// All laws, generated from the list in materials/CMakeLists.txt.
std::span<const MaterialKind> material_kinds();

/// The elastic ones of them combined with Weibull damage (solver/materials/damaged.h). Their names are those of
/// the laws behind this; their parameters are the law's, then those of damage.
std::span<const MaterialKind> damaged_kinds();
inline constexpr std::string_view damage_prefix = "damaged_";

/// nullptr: there is no law of that name, with or without damage.
const MaterialKind* find_material_kind(std::string_view name);

}  // namespace trajan
