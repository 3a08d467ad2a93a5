#include <algorithm>
#include <cmath>

#include "solver/model/checks.h"
#include "solver/model/geometry.h"
#include "solver/model/names.h"
#include "solver/model/polygon.h"
#include "solver/model/triangle_mesh.h"

namespace trajan {

namespace {

constexpr int deepest_nesting = 20;

std::string shapes_of(Dimension dimension) {
  if (dimension == Dimension::bar) return "box";
  return dimension == Dimension::solid ? "box, sphere, cylinder or mesh" : "box, disc or polygon";
}

}  // namespace

template <>
bool Checks::check_shape(const std::string& path, const std::monostate&, bool, int) {
  return violations_.add(path, "", "no shape is given",
                         "give a " + shapes_of(model_.dimension) + ", or a union, intersection or difference");
}

bool Checks::fits_dimension(const std::string& path, bool fits) {
  if (fits || model_.dimension == Dimension::unspecified) return fits;
  return violations_.add(path, "", "not a shape of this dimension", "give a " + shapes_of(model_.dimension));
}

template <>
bool Checks::check_shape(const std::string& path, const Box& box, bool solid, int) {
  const bool lower = check_vector(path + ".box.lower", box.lower);
  if (!check_vector(path + ".box.upper", box.upper) || !lower) return false;
  if (is_above(box.lower, box.upper, solid)) return true;
  return violations_.add(path + ".box.upper", point_text(box.upper, axes()),
                         "not above lower, " + point_text(box.lower, axes()),
                         std::string("give ") + (solid ? "larger" : "no smaller") +
                             " coordinates than those of lower along every axis");
}

template <>
bool Checks::check_shape(const std::string& path, const Disc& disc, bool, int) {
  const bool centre = check_vector(path + ".disc.centre", disc.centre);
  const bool radius = violations_.positive(path + ".disc.radius", disc.radius);
  return fits_dimension(path + ".disc", axes() == 2) && centre && radius;
}

template <>
bool Checks::check_shape(const std::string& path, const Sphere& sphere, bool, int) {
  const bool centre = check_vector(path + ".sphere.centre", sphere.centre);
  const bool radius = violations_.positive(path + ".sphere.radius", sphere.radius);
  return fits_dimension(path + ".sphere", axes() == 3) && centre && radius;
}

template <>
bool Checks::check_shape(const std::string& path, const Cylinder& cylinder, bool, int) {
  const bool from = check_vector(path + ".cylinder.from", cylinder.from);
  const bool to = check_vector(path + ".cylinder.to", cylinder.to);
  const bool radius = violations_.positive(path + ".cylinder.radius", cylinder.radius);
  if (!fits_dimension(path + ".cylinder", axes() == 3) || !from || !to || !radius) return false;
  const double length = std::hypot(cylinder.to.x - cylinder.from.x, cylinder.to.y - cylinder.from.y,
                                   cylinder.to.z - cylinder.from.z);
  if (length > 0 && std::isfinite(length)) return true;
  return violations_.add(path + ".cylinder.to", point_text(cylinder.to, 3), "the cylinder has no length",
                         "give two different ends of its axis");
}

template <>
bool Checks::check_shape(const std::string& path, const Polygon& polygon, bool, int) {
  const std::string corners = path + ".polygon.corners";
  const std::size_t count = polygon.corners.size();
  if (count < 3 || count > most_entries) {
    return violations_.add(corners, std::to_string(count) + " corners", "not a polygon",
                           "give 3 to " + std::to_string(most_entries) + " corners");
  }
  bool good = true;
  for (std::size_t i = 0; i < count; ++i) good = check_vector(indexed(corners, i), polygon.corners[i]) && good;
  if (!fits_dimension(path + ".polygon", axes() == 2) || !good) return false;
  const int crossing = first_crossing(polygon);
  if (crossing < 0) return true;
  return violations_.add(indexed(corners, static_cast<std::size_t>(crossing)),
                         point_text(polygon.corners[static_cast<std::size_t>(crossing)], 2),
                         "the edge from this corner to the next meets another edge",
                         "give the corners in order around the polygon, each once");
}

template <>
bool Checks::check_shape(const std::string& path, const Mesh& mesh, bool, int) {
  const std::string place = path + ".mesh";
  if (!fits_dimension(place, axes() == 3)) return false;
  if (mesh.stl.empty()) {
    return violations_.add(place + ".stl", "", "the mesh has no content",
                           "name its file in `file` and let the client read it, or give the bytes of an STL file");
  }
  try {
    if (!mesh.surface) mesh.surface = std::make_shared<TriangleMesh>(read_stl(mesh.stl));
    return true;
  } catch (const StlError& error) {
    return violations_.add(place + ".stl", "", error.what(), "give the content of an STL file");
  } catch (const MeshError& error) {
    return violations_.add(place + ".stl", "", error.what(), error.remedy());
  }
}

template <>
bool Checks::check_shape(const std::string& path, const Union& set, bool solid, int depth) {
  return check_parts(path + ".union", set.regions, 1, solid, depth);
}

template <>
bool Checks::check_shape(const std::string& path, const Intersection& set, bool solid, int depth) {
  return check_parts(path + ".intersection", set.regions, 2, solid, depth);
}

template <>
bool Checks::check_shape(const std::string& path, const Difference& set, bool solid, int depth) {
  return check_parts(path + ".difference", set.regions, 2, solid, depth);
}

bool Checks::check_region(const std::string& path, const Region& region, bool solid, int depth) {
  const auto check = [&](const auto& shape) { return check_shape(path, shape, solid, depth); };
  return std::visit(check, region);
}

bool Checks::check_parts(const std::string& path, const std::vector<Part>& parts, std::size_t fewest, bool solid,
                         int depth) {
  shapes_ += parts.size();
  if (depth == deepest_nesting) {
    return violations_.add(path, "", "nested too deeply",
                           "give at most " + std::to_string(deepest_nesting) + " levels");
  }
  if (parts.size() < fewest || shapes_ > most_shapes) {
    return violations_.add(path, std::to_string(parts.size()) + " regions",
                           parts.size() < fewest ? "too few regions" : "the scene has too many regions",
                           "give at least " + std::to_string(fewest) + ", and at most " +
                               std::to_string(most_shapes) + " in all of the scene");
  }
  bool good = true;
  for (std::size_t i = 0; i < parts.size(); ++i)
    good = check_region(indexed(path + ".regions", i), parts[i].region, solid, depth + 1) && good;
  return good;
}

}  // namespace trajan
