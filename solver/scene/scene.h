#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// A scene as it was asked for: plain values, not yet checked. Field for field the message
/// `trajan.v1.Scene` (proto/trajan/v1/scene.proto), whose comments give meaning, units, ranges and
/// defaults. Defaults are applied here, so that a value-initialised field is what a user gets who
/// leaves it out. Only `validate` (model/validate.h) reads it.
namespace trajan {

struct Vector {
  double x = 0;
  double y = 0;
};

/// Empty: not given.
struct VectorExpression {
  std::optional<std::string> x;
  std::optional<std::string> y;
};

struct Constant {
  std::string name;
  std::string value;
};

enum class Dimension { unspecified, plane_stress, plane_strain };

struct Domain {
  Dimension dimension = Dimension::unspecified;
  Vector lower;
  Vector upper;
  double cell_size = 0;
  double thickness = 1;
};

/// `law` is a name of the registry of materials (empty: none was given), `parameters` its values by the
/// names of the law's own parameter table.
struct MaterialDefinition {
  std::string name;
  double density = 0;
  std::string law;
  std::map<std::string, double> parameters;
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

struct BodyDefinition {
  std::string name;
  std::string material;
  Region geometry;
  std::int32_t particles_per_cell_side = 2;
  VectorExpression initial_velocity;
};

enum class Axis { unspecified, x, y };

struct Fixed {
  std::vector<Axis> axes;
};

struct PrescribedVelocity {
  VectorExpression velocity;
};

struct BoundaryDefinition {
  std::string name;
  Region nodes;
  std::variant<std::monostate, Fixed, PrescribedVelocity> condition;
};

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

enum class Edge { unspecified, left, right, bottom, top };

struct EdgeTraction {
  std::string body;
  Edge edge = Edge::unspecified;
  Vector traction;
  std::string profile;
};

struct BodyForce {
  Vector acceleration;
  std::vector<std::string> bodies;
};

struct LoadDefinition {
  std::string name;
  std::variant<std::monostate, PointForce, EdgeTraction, BodyForce> kind;
  TimeFunctionDefinition time = 1.0;
};

struct Analysis {
  double end_time = 0;
  double damping = 0;
};

struct Numerics {
  std::string scheme = "MUSL";
  std::string shape_functions = "linear";
  double flip_fraction = 1;
  double time_step_fraction = 0.5;
  std::optional<double> time_step;
  std::optional<std::int32_t> threads;
};

enum class Field { unspecified, position, displacement, velocity, stress };

/// `where`: Vector for the nearest particle, Box or Disc for the mean over a region.
struct ProbeDefinition {
  std::string name;
  std::variant<std::monostate, Vector, Region> where;
  std::vector<Field> fields;
  std::string body;
};

/// `snapshots` empty: 10 or the nearest smaller divisor of `samples`.
struct Outputs {
  std::int32_t samples = 200;
  std::optional<std::int32_t> snapshots;
  std::vector<Field> snapshot_fields = {Field::displacement, Field::stress};
  std::vector<ProbeDefinition> probes;
};

struct FinalValue {};
enum class ExtremeKind { magnitude, maximum, minimum };
struct ExtremeValue {
  ExtremeKind kind = ExtremeKind::magnitude;
};
struct MeanValue {};
struct DominantFrequency {
  double lowest = 0;
  std::optional<double> highest;
};
struct Deviation {
  std::string exact_history;
  double scale = 1;
};

struct MeasureDefinition {
  std::string name;
  std::string quantity;
  std::variant<std::monostate, FinalValue, ExtremeValue, MeanValue, DominantFrequency, Deviation> kind;
  double from = 0;
  std::optional<double> until;
  std::string exact;
  std::string source;
  std::optional<double> tolerance;
};

struct Scene {
  std::string name;
  std::string description;
  std::string units;
  std::vector<Constant> constants;
  Domain domain;
  std::vector<MaterialDefinition> materials;
  std::vector<BodyDefinition> bodies;
  std::vector<BoundaryDefinition> boundaries;
  std::vector<LoadDefinition> loads;
  Analysis analysis;
  Numerics numerics;
  Outputs outputs;
  std::vector<MeasureDefinition> measures;
};

}  // namespace trajan
