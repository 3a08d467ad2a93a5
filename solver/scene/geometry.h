#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Parts of space, as scenes ask for them.
namespace trajan {

struct Vector {
  double x = 0;
  double y = 0;
  double z = 0;
};

/// Empty: not given.
struct VectorExpression {
  std::optional<std::string> x = {};
  std::optional<std::string> y = {};
  std::optional<std::string> z = {};
};

struct Box {
  Vector lower;
  Vector upper;
};

struct Disc {
  Vector centre;
  double radius = 0;
};

struct Sphere {
  Vector centre;
  double radius = 0;
};

struct Cylinder {
  Vector from;
  Vector to;
  double radius = 0;
};

struct Polygon {
  std::vector<Vector> corners;
};

class TriangleMesh;

/// `surface` is what validation has read from `stl`.
struct Mesh {
  std::string stl;
  mutable std::shared_ptr<const TriangleMesh> surface = {};
};

struct Part;

/// The points of any of the regions.
struct Union {
  std::vector<Part> regions;
};

/// The points that all of the regions have.
struct Intersection {
  std::vector<Part> regions;
};

/// The points of the first of the regions that are in none of the others.
struct Difference {
  std::vector<Part> regions;
};

/// monostate: not given.
using Region =
    std::variant<std::monostate, Box, Disc, Sphere, Cylinder, Polygon, Mesh, Union, Intersection, Difference>;

/// An operand of a set operation.
struct Part {
  Region region;
};

/// What a symmetric tensor is given by. Empty: not given.
struct SymmetricTensorExpression {
  std::array<std::optional<std::string>, 6> components = {};  ///< xx, yy, zz, xy, yz, xz
};
inline constexpr std::array<const char*, 6> symmetric_tensor_names = {"xx", "yy", "zz", "xy", "yz", "xz"};

/// What any tensor is given by. Empty: not given.
struct TensorExpression {
  std::array<std::optional<std::string>, 9> components = {};  ///< row by row
};
inline constexpr std::array<const char*, 9> tensor_names = {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};

/// Sides of a box along x, y and z, the lower one first.
enum class Edge { unspecified, left, right, bottom, top, back, front };

/// A part of the surface of a body: an edge of a box, or what lies on a circle; within a region if one is given.
struct Surface {
  std::string body;
  std::variant<std::monostate, Edge, Disc> part;
  Region within = {};
};

}  // namespace trajan
