#include "solver/model/surfaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/model/components.h"
#include "solver/model/polygon.h"
#include "solver/model/selection.h"

namespace trajan {
namespace {

Vector to_vector(const Components& c) { return {c[0], c[1], c[2]}; }
Components to_components(const Vector& v) { return {v.x, v.y, v.z}; }

/// Area along a surface becomes area: times the thickness, or the radius in axisymmetric scenes.
double depth(const Model& model, const Vector& at) {
  if (model.dimension == Dimension::axisymmetric) return at.x;
  return grid_axes(model.dimension) == 3 ? 1 : model.thickness;
}

/// Points on a circle or a sphere at equal areas.
struct RimPlace {
  Components normal;
  std::array<Components, 2> tangents;  ///< their product is the normal times the area
};

/// Equal arcs are exact for trigonometric profiles.
RimPlace on_circle(std::int64_t i, std::int64_t count, double radius) {
  const double angle = 2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
  const double arc = 2 * std::numbers::pi * radius / static_cast<double>(count);
  const double c = std::cos(angle), s = std::sin(angle);
  return {{c, s, 0}, {{{-arc * s, arc * c, 0}, {0, 0, 1}}}};
}

/// A spiral of equal areas (Swinbank and Purser 2006, the Fibonacci grid).
RimPlace on_sphere(std::int64_t i, std::int64_t count, double radius) {
  const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
  const double angle = 2 * std::numbers::pi * std::fmod(static_cast<double>(i) / std::numbers::phi, 1.0);
  const double side = std::sqrt(4 * std::numbers::pi * radius * radius / static_cast<double>(count));
  const double rho = std::sqrt(std::max(0.0, 1 - z * z)), c = std::cos(angle), s = std::sin(angle);
  return {{rho * c, rho * s, z}, {{{side * z * c, side * z * s, -side * rho}, {-side * s, side * c, 0}}}};
}

double spacing_of(const Lattice& lattice, int axes) {
  double least = lattice.spacing.x;
  if (axes > 1) least = std::min(least, lattice.spacing.y);
  if (axes > 2) least = std::min(least, lattice.spacing.z);
  return least;
}

bool is_inside(const Body& body, const Vector& at) { return !(distance_from(body.lattice.geometry, at) > 0); }

}  // namespace

int normal_axis(Edge edge) { return (static_cast<int>(edge) - static_cast<int>(Edge::left)) / 2; }

bool is_upper(Edge edge) { return (static_cast<int>(edge) - static_cast<int>(Edge::left)) % 2 == 1; }

double count_edge_points(const Body& body, Edge edge, int axes) {
  const double counts[] = {static_cast<double>(body.lattice.columns), static_cast<double>(body.lattice.rows),
                           static_cast<double>(body.lattice.planes)};
  double points = 1;
  for (int axis = 0; axis < axes; ++axis)
    if (axis != normal_axis(edge)) points *= 2 * counts[axis];
  return points;
}

std::vector<SurfacePoint> edge_points(const Model& model, const Body& body, Edge edge) {
  const Lattice& lattice = body.lattice;
  const Box& box = std::get<Box>(lattice.geometry);
  const int axes = grid_axes(model.dimension);
  const auto normal = static_cast<std::size_t>(normal_axis(edge)), one = (normal + 1) % 3, two = (normal + 2) % 3;
  const std::array<std::int64_t, 3> counts = {lattice.columns, lattice.rows, lattice.planes};
  const Components first = to_components(lattice.first), spacing = to_components(lattice.spacing);
  const std::int64_t layer = is_upper(edge) ? counts[normal] - 1 : 0;
  const double level = to_components(is_upper(edge) ? box.upper : box.lower)[normal];
  const auto has = [&](std::size_t axis) { return static_cast<int>(axis) < axes; };
  const double length_one = has(one) ? spacing[one] / 2 : 1, length_two = has(two) ? spacing[two] / 2 : 1;
  std::vector<SurfacePoint> points;
  for (std::int64_t j = 0; j < (has(two) ? 2 * counts[two] : 1); ++j)
    for (std::int64_t i = 0; i < (has(one) ? 2 * counts[one] : 1); ++i) {
      std::array<std::int64_t, 3> index{};
      Components at{};
      const auto along = [&](std::size_t axis, std::int64_t gauss) {
        const double offset = (gauss % 2 == 0 ? -1 : 1) / std::sqrt(3.0) / 2;
        index[axis] = gauss / 2;
        if (has(axis)) at[axis] = first[axis] + (static_cast<double>(index[axis]) + offset) * spacing[axis];
      };
      along(one, i);
      along(two, j);
      index[normal] = layer;
      at[normal] = level;
      std::array<Components, 2> tangents{};
      tangents[0][one] = is_upper(edge) ? length_one : -length_one;
      tangents[1][two] = length_two;
      SurfacePoint point;
      point.carrier = body.first_particle + (index[2] * counts[1] + index[1]) * counts[0] + index[0];
      point.position = to_vector(at);
      point.area = length_one * length_two * depth(model, point.position);
      point.tangents = {to_vector(tangents[0]), to_vector(tangents[1])};
      points.push_back(point);
    }
  return points;
}

std::vector<SurfacePoint> polygon_edge_points(const Model& model, const Body& body, Edge edge,
                                              SearchBudget& budget) {
  const auto& polygon = std::get<Polygon>(body.lattice.geometry);
  const Box bounds = bounds_of(polygon);
  const auto normal = static_cast<std::size_t>(normal_axis(edge)), along = 1 - normal;
  const double level = to_components(is_upper(edge) ? bounds.upper : bounds.lower)[normal];
  const double spacing = to_components(body.lattice.spacing)[along];
  std::vector<SurfacePoint> points;
  for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
    const Components a = to_components(polygon.corners[k]);
    const Components b = to_components(polygon.corners[(k + 1) % polygon.corners.size()]);
    if (a[normal] != level || b[normal] != level) continue;
    const double from = std::min(a[along], b[along]), size = std::abs(b[along] - a[along]);
    const double parts = std::max(1.0, std::round(size / spacing)), length = size / parts / 2;
    for (std::int64_t i = 0; i < 2 * static_cast<std::int64_t>(parts) && budget.rows >= 0; ++i) {
      const double offset = (i % 2 == 0 ? -1 : 1) / std::sqrt(3.0);
      Components at{};
      at[normal] = level;
      const std::int64_t middle = i / 2 * 2 + 1;
      at[along] = from + (static_cast<double>(middle) + offset) * length;
      // Their product is the outer normal, as it is on a box.
      const double sense = is_upper(edge) ? 1 : -1;
      std::array<Components, 2> tangents{};
      tangents[0][normal == 0 ? 1 : 2] = sense * (normal == 0 ? length : 1);
      tangents[1][normal == 0 ? 2 : 0] = normal == 0 ? 1 : length;
      SurfacePoint point;
      point.position = to_vector(at);
      const NearestParticle carrier = nearest_particle(body, point.position);
      budget.rows -= carrier.rows;
      point.carrier = carrier.particle;
      point.area = length * depth(model, point.position);
      point.tangents = {to_vector(tangents[0]), to_vector(tangents[1])};
      points.push_back(point);
    }
  }
  return points;
}

double count_rim_points(const Body& body, const Disc& rim, int axes) {
  const double half = spacing_of(body.lattice, axes) / 2;
  const double around = std::ceil(2 * std::numbers::pi * rim.radius / half);
  return axes == 3 ? std::ceil(around * around / std::numbers::pi) : around;
}

std::vector<SurfacePoint> rim_points(const Model& model, const Body& body, const Disc& rim, SearchBudget& budget) {
  const int axes = grid_axes(model.dimension);
  const auto count = static_cast<std::int64_t>(count_rim_points(body, rim, axes));
  const double spacing = spacing_of(body.lattice, axes);
  std::vector<SurfacePoint> points;
  for (std::int64_t i = 0; i < count && budget.rows >= 0; ++i) {
    RimPlace place = axes == 3 ? on_sphere(i, count, rim.radius) : on_circle(i, count, rim.radius);
    const auto at = [&](double radius) {
      return Vector{rim.centre.x + radius * place.normal[0], rim.centre.y + radius * place.normal[1],
                    rim.centre.z + radius * place.normal[2]};
    };
    // Half a spacing to both sides tells the body from what is outside of it.
    const bool within = is_inside(body, at(rim.radius - spacing / 2));
    if (within == is_inside(body, at(rim.radius + spacing / 2))) continue;
    const NearestParticle carrier = nearest_particle(body, at(rim.radius));
    budget.rows -= carrier.rows;
    if (carrier.distance > 2 * spacing) continue;
    if (!within)
      for (double& component : place.tangents[0]) component = -component;
    SurfacePoint point;
    point.carrier = carrier.particle;
    point.position = at(rim.radius);
    const double around = 2 * std::numbers::pi * rim.radius / static_cast<double>(count);
    point.area = axes == 3 ? 4 * std::numbers::pi * rim.radius * rim.radius / static_cast<double>(count)
                           : around * depth(model, point.position);
    point.tangents = {to_vector(place.tangents[0]), to_vector(place.tangents[1])};
    points.push_back(point);
  }
  return points;
}

}  // namespace trajan
