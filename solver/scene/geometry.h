#pragma once

#include <optional>
#include <string>
#include <variant>

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

/// monostate: not given.
using Region = std::variant<std::monostate, Box, Disc>;

/// Sides of a box along x, y and z, the lower one first.
enum class Edge { unspecified, left, right, bottom, top, back, front };

/// A part of the surface of a body: an edge of a box, or what lies on a circle; within a region if one is given.
struct Surface {
  std::string body;
  std::variant<std::monostate, Edge, Disc> part;
  Region within = {};
};

}  // namespace trajan
