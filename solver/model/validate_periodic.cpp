#include <cmath>

#include "solver/model/names.h"
#include "solver/model/surfaces.h"
#include "solver/model/validator.h"

namespace trajan {
namespace {

/// Cells, so that no particle sees a node twice.
constexpr double least_period = 4;

}  // namespace

void Validator::check_periods() {
  for (std::size_t i = 0; i < scene_.boundaries.size() && scene_.boundaries.size() <= most_entries; ++i)
    if (const auto* periodic = std::get_if<Periodic>(&scene_.boundaries[i].condition))
      check_period(indexed("boundaries", i) + ".periodic.axis", periodic->axis);
}

void Validator::check_period(const std::string& path, Axis axis) {
  if (!check_axis(path, axis) || !grid_complete_) return;
  const int along = static_cast<int>(axis) - static_cast<int>(Axis::x);
  const std::string name = axis_names[static_cast<std::size_t>(along)];
  if (model_.dimension == Dimension::axisymmetric && along == 0) {
    violations_.add(path, name, "the radius does not repeat itself", "give Y, the axis");
    return;
  }
  if (is_periodic(along)) {
    violations_.add(path, name, "the domain is periodic along this axis already", "leave it out");
    return;
  }
  const Vector &from = scene_.domain.lower, &to = scene_.domain.upper;
  const double extents[] = {to.x - from.x, to.y - from.y, to.z - from.z};
  const double cell = model_.grid.cell, cells = extents[along] / cell;
  const double whole = std::max(least_period, std::round(cells));
  if (std::abs(cells - whole) > node_tolerance * cells) {
    violations_.add("domain.upper." + name, number_text(cells) + " cells",
                    "a periodic axis needs a whole number of cells, at least " + number_text(least_period),
                    "give domain.lower." + name + " + " + number_text(whole * cell) + " (" + number_text(whole) +
                        " cells), or cell_size " + number_text(extents[along] / whole));
    return;
  }
  model_.grid.periodic[static_cast<std::size_t>(along)] = true;
}

void Validator::check_solid_face(const std::string& path, Edge face) {
  if (is_periodic(normal_axis(face)))
    violations_.add(path, "", "the domain repeats itself here and has no face",
                    "choose another face, or leave out the periodic condition");
}

}  // namespace trajan
