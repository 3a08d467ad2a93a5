#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solver/materials/material.h"
#include "solver/model/boundaries.h"
#include "solver/model/contacts.h"
#include "solver/model/expression.h"
#include "solver/model/fields.h"
#include "solver/model/lattice.h"
#include "solver/model/output_plan.h"
#include "solver/model/time_function.h"
#include "solver/scene/scene.h"

/// A validated scene. Only `validate` makes a Model, everything in it is consistent, and nothing that
/// reads it checks again. It is never changed, and bodies are lattices that the Simulation fills.
namespace trajan {

/// The background grid: nodes at origin + cell * (i, j, k), 0 <= i <= cells_x, 0 <= j <= cells_y,
/// 0 <= k <= cells_z; along an axis that the dimension does not have there are no cells.
struct Grid {
  Vector origin;
  double cell = 0;
  std::int64_t cells_x = 0;
  std::int64_t cells_y = 0;
  std::int64_t cells_z = 0;
  std::array<bool, 3> periodic{};  ///< axes along which the last nodes are the first ones

  std::array<std::int64_t, 3> cells() const { return {cells_x, cells_y, cells_z}; }
};

struct Material {
  std::string name;
  const MaterialKind* kind = nullptr;
  std::vector<double> parameters;  ///< in the order of kind->parameters
  double density = 0;              ///< at rest
};

/// Particles are numbered over all bodies in the order of bodies and, within one, of its lattice
/// (x fastest). These numbers are the particles' identities in every output.
struct Body {
  std::string name;
  std::size_t material = 0;
  Lattice lattice;
  std::int64_t first_particle = 0;
  std::int64_t particles = 0;
  /// Mean reference volume of a particle, thickness or cross-section included; in an axisymmetric scene the
  /// area, to be multiplied by the particle's radius. A particle has its share of the lattice.
  /// With an initial deformation it is that of the stress-free state.
  double particle_volume = 0;
  std::optional<Expression> velocity_x;  ///< of the position; empty: 0
  std::optional<Expression> velocity_y;
  std::optional<Expression> velocity_z;
  std::array<std::optional<Expression>, 6> stress;       ///< Cauchy, of the position: xx, yy, zz, xy, yz, xz
  std::array<std::optional<Expression>, 9> deformation;  ///< gradient, of the position, row by row
};

/// A force on a point of a body's surface.
struct LoadPoint : SurfacePoint {
  Vector force;         ///< dead, times the time function of its group
  double pressure = 0;  ///< of one that follows the surface
};

/// Loads on surface points that share a time function.
struct SurfaceLoad {
  std::string name;
  std::vector<LoadPoint> points;
  TimeFunction time;
  bool follows = false;  ///< pressure times normal and area as they are now, no dead force
};

/// An acceleration of whole bodies: uniform, and by formulas of the position and t.
struct BodyLoad {
  std::string name;
  Vector acceleration;
  std::array<std::optional<Expression>, 3> field;
  bool reference = false;           ///< the field is evaluated at reference positions
  std::vector<std::size_t> bodies;  ///< indices; all of them: every body
  TimeFunction time;
};

class Model {
 public:
  std::string name, description, units;
  Dimension dimension = Dimension::unspecified;
  double thickness = 1;  ///< in a bar the area of its cross-section, axisymmetric and solid 1
  Grid grid;
  std::vector<Material> materials;
  std::vector<Body> bodies;
  std::vector<BoundaryCondition> conditions;  ///< in the order of the scene
  ContactPlan contacts;
  std::vector<SurfaceLoad> surface_loads;
  std::vector<BodyLoad> body_loads;
  double end_time = 0;
  double damping = 0;
  AnalysisKind analysis;
  Numerics numerics;  ///< names of registered schemes and shape functions
  OutputPlan outputs;
  std::vector<Measure> measures;

  std::int64_t particle_count() const {
    return bodies.empty() ? 0 : bodies.back().first_particle + bodies.back().particles;
  }

 private:
  friend class Checks;
  Model() = default;
};

/// Whether bodies may touch each other or rigid bodies.
bool has_contact(const Model& model);

/// Names of the histories' columns, in the order in which they are sampled: probes in the order of the
/// scene ("tip.displacement.x", …), then "energies.kinetic", "energies.strain", "energies.work",
/// "energies.dissipated", "energies.total", "energies.balance_error" and, where there is contact,
/// "energies.contact", then "momentum.x" and, as far as vectors have them, "momentum.y" and "momentum.z", then
/// likewise the forces of boundary conditions and then of contact on bodies that are asked for,
/// "reactions.support.x", and of a relaxation "relaxation.residual" and "relaxation.steps".
std::vector<std::string> history_columns(const Model& model);

}  // namespace trajan
