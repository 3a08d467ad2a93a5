#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/validator.h"
#include "solver/schemes/scheme.h"

namespace trajan {

namespace {

/// Particles at which a volume ratio is looked at that must be uniform.
constexpr std::int64_t most_looks = 1000;

/// Why a component of the initial stress cannot be given; empty: it can.
std::string_view stress_objection(Dimension dimension, std::size_t component) {
  constexpr std::size_t zz = 2, yz = 4, xz = 5;
  switch (dimension) {
    case Dimension::bar:
      return component == 0 ? "" : "it is zero in a bar";
    case Dimension::plane_stress:
      if (component == zz) return "it is zero in plane stress";
      [[fallthrough]];
    case Dimension::plane_strain:
    case Dimension::axisymmetric:
      return component == yz || component == xz ? "it is zero in a plane" : "";
    default:
      return "";
  }
}

/// The same of the initial deformation gradient.
std::string_view deformation_objection(Dimension dimension, std::size_t component) {
  const std::size_t row = component / 3, column = component % 3;
  const auto axes = static_cast<std::size_t>(grid_axes(dimension));
  if (row < axes && column < axes) return "";
  if (row != column) return "there is no shear out of the axes of the grid";
  switch (dimension) {
    case Dimension::bar:
    case Dimension::plane_stress:
      return "it follows from the stress there, which is zero";
    case Dimension::plane_strain:
      return "it is 1 in plane strain";
    default:
      return "";
  }
}

/// Formulas for all components that are given; an objection to one is a violation.
template <std::size_t N, class Objection, class Make>
bool check_components(Violations& violations, const std::string& path,
                      const std::array<std::optional<std::string>, N>& given,
                      const std::array<const char*, N>& names, Objection objection, Make make) {
  bool any = false;
  for (std::size_t i = 0; i < N; ++i) {
    if (!given[i]) continue;
    any = true;
    const std::string place = path + "." + names[i];
    if (const std::string_view why = objection(i); !why.empty()) {
      violations.add(place, *given[i], "not free to be given: " + std::string(why), "leave it out");
    } else {
      make(place, i);
    }
  }
  return any;
}

double initial_volume_ratio(const Body& body, Vector place) {
  double f[9];
  for (std::size_t i = 0; i < 9; ++i)
    f[i] = body.deformation[i] ? (*body.deformation[i])(place, 0) : i % 4 == 0 ? 1.0 : 0.0;
  return f[0] * (f[4] * f[8] - f[5] * f[7]) - f[1] * (f[3] * f[8] - f[5] * f[6]) +
         f[2] * (f[3] * f[7] - f[4] * f[6]);
}

}  // namespace

void Validator::check_initial_state(const std::string& path, const BodyDefinition& definition, Body& body,
                                    Vector place) {
  check_initial_stress(path + ".initial_stress", definition, body, place);
  check_initial_deformation(path + ".initial_deformation", definition, body, place);
}

void Validator::check_initial_stress(const std::string& path, const BodyDefinition& definition, Body& body,
                                     Vector place) {
  const auto& given = definition.initial_stress.components;
  const bool any = check_components(
      violations_, path, given, symmetric_tensor_names,
      [this](std::size_t i) { return stress_objection(model_.dimension, i); },
      [&](const std::string& where, std::size_t i) {
        body.stress[i] = formula(where, *given[i], place_variables(), place);
      });
  const MaterialKind* law = law_of(body);
  if (any && law != nullptr && !law->rate_form) {
    violations_.add(path, "", "the law " + quoted(law->name) + " is a function of the deformation",
                    "give initial_deformation instead, or another law");
  }
}

void Validator::check_initial_deformation(const std::string& path, const BodyDefinition& definition, Body& body,
                                          Vector place) {
  const auto& given = definition.initial_deformation.components;
  const bool any = check_components(
      violations_, path, given, tensor_names,
      [this](std::size_t i) { return deformation_objection(model_.dimension, i); },
      [&](const std::string& where, std::size_t i) {
        body.deformation[i] = formula(where, *given[i], place_variables(), place);
      });
  const MaterialKind* law = law_of(body);
  if (!any || law == nullptr) return;
  if (law->rate_form) {
    violations_.add(path, "", "the law " + quoted(law->name) + " has a stress as its state",
                    "give initial_stress instead, or another law");
  } else if (is_total_lagrangian(scene_.numerics.scheme)) {
    violations_.add(path, "", "a total Lagrangian scheme begins in the stress-free state",
                    "choose an updated Lagrangian scheme");
  } else if (body.particles > 0) {
    check_volume_ratio(path, body);
  }
}

/// The particles of a body have one volume, and so must they have had before they were deformed.
void Validator::check_volume_ratio(const std::string& path, Body& body) {
  const double ratio = initial_volume_ratio(body, body.lattice.point_of(0));
  const std::int64_t step = body.particles / most_looks + 1;
  for (std::int64_t number = 0; number < body.particles; number += step) {
    const Vector place = body.lattice.point_of(number);
    const double here = initial_volume_ratio(body, place);
    if (!(std::isfinite(here) && here > 0)) {
      violations_.add(path, "", "its determinant is " + number_text(here) + " at " + point_text(place, axes()),
                      "give a deformation gradient with a positive determinant");
      return;
    }
    if (std::abs(here - ratio) > 1e-9 * ratio) {
      violations_.add(path, "",
                      "its determinant is not uniform: " + number_text(ratio) + " and, at " +
                          point_text(place, axes()) + ", " + number_text(here),
                      "give one with the same determinant everywhere");
      return;
    }
  }
  body.particle_volume /= ratio;
}

const MaterialKind* Validator::law_of(const Body& body) const {
  return body.material < model_.materials.size() ? model_.materials[body.material].kind : nullptr;
}

}  // namespace trajan
