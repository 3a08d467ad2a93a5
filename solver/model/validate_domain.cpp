#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/validator.h"

namespace trajan {

namespace {

constexpr std::string_view dimensions = "BAR, PLANE_STRESS, PLANE_STRAIN, AXISYMMETRIC or SOLID";

std::string_view description(Dimension dimension) {
  switch (dimension) {
    case Dimension::bar:
      return "a bar";
    case Dimension::plane_stress:
    case Dimension::plane_strain:
      return "a plane";
    case Dimension::axisymmetric:
      return "an axisymmetric scene";
    default:
      return "a solid";
  }
}

}  // namespace

void Validator::check_domain() {
  const Domain& domain = scene_.domain;
  model_.dimension = domain.dimension;
  if (domain.dimension == Dimension::unspecified) {
    violations_.add("domain.dimension", "", "not given", "choose " + std::string(dimensions));
  }
  const bool lower = check_vector("domain.lower", domain.lower);
  const bool upper = check_vector("domain.upper", domain.upper);
  bool good = lower && upper;
  if (good && !is_above(domain.lower, domain.upper, true)) {
    good = violations_.add("domain.upper", point_text(domain.upper, axes()),
                           "not above domain.lower, " + point_text(domain.lower, axes()),
                           "give larger coordinates than those of domain.lower along every axis");
  }
  if (domain.dimension == Dimension::axisymmetric && lower && domain.lower.x < 0) {
    good = violations_.add("domain.lower.x", number_text(domain.lower.x), "x is the radius and cannot be negative",
                           "give 0 (the axis) or a positive radius");
  }
  good = violations_.positive("domain.cell_size", domain.cell_size) && good;
  check_extent();
  if (good) check_grid("domain.cell_size");
}

/// What a scene says about the extent of space that has no axis.
void Validator::check_extent() {
  const Domain& domain = scene_.domain;
  const std::string owner(description(domain.dimension));
  const bool plane = domain.dimension == Dimension::plane_stress || domain.dimension == Dimension::plane_strain;
  const bool bar = domain.dimension == Dimension::bar;
  const auto check = [&](const char* path, const std::optional<double>& value, bool has_it, const char* instead) {
    if (!value) return;
    if (!violations_.positive(path, *value) || domain.dimension == Dimension::unspecified) return;
    if (has_it) {
      model_.thickness = *value;
    } else {
      violations_.add(path, number_text(*value), owner + " has none", instead);
    }
  };
  check("domain.thickness", domain.thickness, plane, bar ? "give cross_section instead" : "leave it out");
  check("domain.cross_section", domain.cross_section, bar, plane ? "give thickness instead" : "leave it out");
}

void Validator::check_grid(const std::string& path) {
  const Domain& domain = scene_.domain;
  const double cell = domain.cell_size;
  double cells[3] = {0, 0, 0}, most = 0, farthest = 0, longest = 0;
  for (int axis = 0; axis < axes(); ++axis) {
    const double from = domain.lower.*component[axis], to = domain.upper.*component[axis];
    cells[axis] = std::max(1.0, std::ceil((to - from) / cell - node_tolerance));
    most = std::max(most, cells[axis]);
    longest = std::max(longest, to - from);
    farthest = std::max({farthest, std::abs(from), std::abs(to)});
  }
  if (!(most <= most_cells)) {
    violations_.add(path, number_text(cell), "this makes " + number_text(most) + " cells along an axis",
                    "give larger cells or a smaller domain: at most 2^30 cells along an axis");
    return;
  }
  if (!(cell <= longest * (1 + node_tolerance))) {
    violations_.add(path, number_text(cell), "larger than the domain, " + number_text(longest),
                    "give a cell that fits into the domain");
    return;
  }
  // Beyond this, coordinates are not accurate to a millionth of a cell.
  if (!(farthest / cell <= 2 * most_cells)) {
    violations_.add(path, number_text(cell), "too small for coordinates as large as " + number_text(farthest),
                    "move the scene closer to the origin: at most 2^31 cells away");
    return;
  }
  const auto whole = [&](int axis) { return static_cast<std::int64_t>(cells[axis]); };
  model_.grid = {domain.lower, cell, whole(0), whole(1), whole(2)};
  grid_complete_ = true;
}

bool Checks::is_above(Vector lower, Vector upper, bool strictly) const {
  for (int axis = 0; axis < axes(); ++axis) {
    const double extent = upper.*component[axis] - lower.*component[axis];
    if (!(strictly ? extent > 0 : extent >= 0)) return false;
  }
  return true;
}

bool Checks::check_vector(const std::string& path, Vector value) {
  bool good = true;
  for (int axis = 0; axis < 3; ++axis) {
    const double number = value.*component[axis];
    const std::string place = path + "." + axis_names[axis];
    good = violations_.finite(place, number) && good;
    if (axis >= axes() && std::isfinite(number) && number != 0) no_axis(place, number_text(number), axis);
  }
  return good;
}

void Checks::no_axis(const std::string& path, const std::string& value, int axis) {
  if (model_.dimension == Dimension::unspecified) return;
  violations_.add(path, value,
                  std::string(description(model_.dimension)) + " has no " + axis_names[axis] + " axis",
                  "leave it out, or choose another domain.dimension");
}

std::string Checks::place_variables() const {
  return std::string("xyz").substr(0, static_cast<std::size_t>(axes()));
}

}  // namespace trajan
