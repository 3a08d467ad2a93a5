#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/scene/analysis.h"
#include "solver/scene/boundaries.h"
#include "solver/scene/contacts.h"
#include "solver/scene/geometry.h"
#include "solver/scene/loads.h"
#include "solver/scene/outputs.h"

/// A scene as it was asked for: plain values, not yet checked. Field for field the message
/// `trajan.v1.Scene` (proto/trajan/v1/scene.proto and the files that it imports), whose comments give
/// meaning, units, ranges and defaults. Defaults are applied here, so that a value-initialised field is
/// what a user gets who leaves it out. Only `validate` (model/validate.h) reads it.
namespace trajan {

struct Constant {
  std::string name;
  std::string value;
};

enum class Dimension { unspecified, bar, plane_stress, plane_strain, axisymmetric, solid };

/// How many axes the grid has.
constexpr int grid_axes(Dimension dimension) {
  return dimension == Dimension::bar ? 1 : dimension == Dimension::solid ? 3 : 2;
}

struct Domain {
  Dimension dimension = Dimension::unspecified;
  Vector lower;
  Vector upper;
  double cell_size = 0;
  std::optional<double> thickness = {};
  std::optional<double> cross_section = {};
};

/// `law` is a name of the registry of materials (empty: none was given), `parameters` its values by the
/// names of the law's own parameter table.
struct MaterialDefinition {
  std::string name;
  double density = 0;
  std::string law;
  std::map<std::string, double> parameters;
  std::optional<std::map<std::string, double>> damage = {};  ///< parameters of Weibull damage on top of the law
};

enum class ParticleLayout { unspecified, uniform, gauss };

struct BodyDefinition {
  std::string name;
  std::string material;
  Region geometry;
  std::int32_t particles_per_cell_side = 2;
  VectorExpression initial_velocity;
  SymmetricTensorExpression initial_stress = {};
  TensorExpression initial_deformation = {};
  ParticleLayout particle_layout = ParticleLayout::uniform;
};

/// Of transfers that have an order.
inline constexpr std::int32_t default_transfer_order = 2;

struct Numerics {
  std::string scheme = "MUSL";
  std::string shape_functions = "linear";
  std::string transfer = "FLIP";
  std::optional<double> flip_fraction;
  std::optional<std::int32_t> transfer_order;
  double time_step_fraction = 0.5;
  std::optional<double> time_step;
  std::optional<std::int32_t> threads;
  std::string locking_remedy = "none";
  std::string precision = "DOUBLE";
};
inline constexpr std::string_view float_precision = "FLOAT";  ///< what else the precision may be

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
  std::vector<BodyContact> contacts = {};
};

}  // namespace trajan
