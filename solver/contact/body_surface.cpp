#include "solver/contact/body_surface.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "solver/model/geometry.h"

namespace trajan {
namespace {

/// In cells: differences of distances over this give normals.
constexpr double step = 1e-4;
/// In particles' sizes: boundaries further from a side are no part of what the particle shows there.
constexpr double furthest = 1.5;

bool contains(const Lattice::Ranges& ranges, std::int64_t column) {
  return std::ranges::any_of(ranges, [&](const auto& r) { return column >= r.begin && column < r.end; });
}

struct Coordinates {
  Vector vector;
  double& operator[](std::size_t axis) { return axis == 0 ? vector.x : axis == 1 ? vector.y : vector.z; }
  double operator[](std::size_t axis) const { return axis == 0 ? vector.x : axis == 1 ? vector.y : vector.z; }
};

/// The gradient of the distance from the boundary, of unit length unless it is zero.
Components outwards(const Region& region, Vector at, int axes, double by) {
  Components gradient{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes); ++axis) {
    Coordinates ahead{at}, behind{at};
    ahead[axis] += by;
    behind[axis] -= by;
    gradient[axis] = signed_distance(region, ahead.vector) - signed_distance(region, behind.vector);
  }
  const double length = std::sqrt(dot(gradient, gradient));
  for (double& component : gradient) component = length > 0 ? component / length : 0;
  return gradient;
}

/// Whether a body that moves with this one, perhaps across a face where the grid repeats itself, is there.
bool is_covered(const Model& model, const Body& body, Vector at) {
  const Coordinates origin{model.grid.origin};
  Coordinates place{at};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double period = model.grid.cell * static_cast<double>(model.grid.cells()[axis]);
    if (model.grid.periodic[axis]) place[axis] -= period * std::floor((place[axis] - origin[axis]) / period);
  }
  const auto field = [&](const Body& of) {
    const auto index = static_cast<std::size_t>(&of - model.bodies.data());
    return model.contacts.fields > 1 ? model.contacts.field_of[index] : 0;
  };
  return std::ranges::any_of(model.bodies, [&](const Body& other) {
    return field(other) == field(body) && signed_distance(other.lattice.geometry, place.vector) < 0;
  });
}

/// Takes back what a particle is deformed by at time 0.
void undo_deformation(const Body& body, Vector particle, BoundaryPoint& point) {
  if (std::ranges::none_of(body.deformation, [](const auto& formula) { return formula.has_value(); })) return;
  Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
  for (std::size_t i = 0; i < body.deformation.size(); ++i)
    if (body.deformation[i])
      f(static_cast<int>(i / 3), static_cast<int>(i % 3)) = (*body.deformation[i])(particle, 0);
  Eigen::Map<Eigen::Vector3d> from(point.from.data()), normal(point.normal.data());
  from = f.inverse() * from;
  normal = (f.transpose() * normal).normalized();
}

}  // namespace

BodySurface::BodySurface(const Model& model, const Body& body) {
  const Lattice& lattice = body.lattice;
  const int axes = grid_axes(model.dimension);
  const double cell = model.grid.cell;
  const Coordinates spacing{lattice.spacing};
  const auto add = [&](Vector particle, std::size_t axis, double side) {
    Coordinates middle{particle};
    middle[axis] += side * 0.5 * spacing[axis];
    const double distance = signed_distance(lattice.geometry, middle.vector);
    const Components normal = outwards(lattice.geometry, middle.vector, axes, step * cell);
    if (dot(normal, normal) == 0 || std::abs(distance) > furthest * spacing[axis]) return;
    BoundaryPoint point{{}, normal};
    Coordinates outside{particle};
    for (std::size_t a = 0; a < static_cast<std::size_t>(axes); ++a) {
      point.from[a] = (middle[a] - distance * normal[a] - Coordinates{particle}[a]) / cell;
      outside[a] += cell * (point.from[a] + step * normal[a]);
    }
    if (is_covered(model, body, outside.vector)) return;
    undo_deformation(body, particle, point);
    points_.push_back(point);
  };
  first_.reserve(static_cast<std::size_t>(body.particles) + 1);
  const auto columns_of = [&](std::int64_t j, std::int64_t k) {
    const bool there = j >= 0 && j < lattice.rows && k >= 0 && k < lattice.planes;
    return there ? lattice.columns_in_row(k * lattice.rows + j) : Lattice::Ranges{};
  };
  for (std::int64_t row = 0; row < lattice.row_count(); ++row) {
    const std::int64_t j = row % lattice.rows, k = row / lattice.rows;
    const Lattice::Ranges here = columns_of(j, k);
    if (here.empty()) continue;
    const Lattice::Ranges around[] = {columns_of(j - 1, k), columns_of(j + 1, k), columns_of(j, k - 1),
                                      columns_of(j, k + 1)};
    for (const Lattice::Range& range : here)
      for (std::int64_t column = range.begin; column < range.end; ++column) {
        first_.push_back(static_cast<std::uint32_t>(points_.size()));
        const Vector particle = lattice.point(column, row);
        if (!contains(here, column - 1)) add(particle, 0, -1);
        if (!contains(here, column + 1)) add(particle, 0, 1);
        for (std::size_t side = 0; side < 2 * static_cast<std::size_t>(axes - 1); ++side)
          if (!contains(around[side], column)) add(particle, 1 + side / 2, side % 2 == 0 ? -1 : 1);
      }
  }
  first_.push_back(static_cast<std::uint32_t>(points_.size()));
}

}  // namespace trajan
