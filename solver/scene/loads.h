#pragma once

#include <string>
#include <variant>
#include <vector>

#include "solver/scene/geometry.h"

/// Loads and their time functions, as scenes ask for them.
namespace trajan {

struct Ramp {
  double start = 0;
  double duration = 0;
  bool smooth = false;
};

struct Sine {
  double frequency = 0;
  double phase = 0;
};

struct Table {
  std::vector<double> times;
  std::vector<double> values;
};

/// double: constant; string: an expression of t.
using TimeFunctionDefinition = std::variant<double, Ramp, Sine, Table, std::string>;

struct PointForce {
  std::string body;
  Vector position;
  Vector force;
};

struct EdgeTraction {
  std::string body;
  Edge edge = Edge::unspecified;
  Vector traction;
  std::string profile;
  Region within = {};
};

struct Pressure {
  Surface surface;
  double pressure = 0;
  std::string profile;
  bool follows = true;  ///< the current configuration
};

struct BodyForce {
  Vector acceleration;
  std::vector<std::string> bodies;
  VectorExpression field = {};
  bool reference = false;  ///< configuration in which the field is evaluated
};

struct LoadDefinition {
  std::string name;
  std::variant<std::monostate, PointForce, EdgeTraction, BodyForce, Pressure> kind;
  TimeFunctionDefinition time = 1.0;
};

}  // namespace trajan
