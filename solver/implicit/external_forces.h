#pragma once

#include <span>

#include "solver/implicit/assembly.h"
#include "solver/implicit/discretization.h"

namespace trajan {

/// Loads on the nodes: surface loads, dead or following the surface as it deforms within the step, gravity and
/// body forces. Fields that depend on present places are evaluated at those of the step's beginning.
class ExternalForces {
 public:
  explicit ExternalForces(const Model& model, Executor& executor) : model_(model), executor_(executor) {}

  /// Whether they depend on displacements, which makes tangents unsymmetric.
  bool follow() const;
  /// Adds the forces of a time, after a displacement since the step's beginning. With `stiffness` subtracts their
  /// derivative from it, whose pattern must have the carriers' nodes. Outside of the run's time loads go on as
  /// straight as they end. Throws FormulaNotFinite.
  void add(const Discretization& on, double time, std::span<const double> displacement, std::span<double> forces,
           SparseMatrix* stiffness = nullptr);

 private:
  /// Forces times a share, of a time of the run.
  void add_share(const Discretization& on, double time, double share, std::span<const double> displacement,
                 std::span<double> forces, SparseMatrix* stiffness);
  void add_body_loads(const Discretization& on, double share, std::span<double> forces);
  void add_dead_loads(const Discretization& on, std::size_t load, double share, std::span<double> forces);
  void add_pressure(const Discretization& on, std::size_t load, double share, std::span<const double> displacement,
                    std::span<double> forces, SparseMatrix* stiffness);

  const Model& model_;
  Executor& executor_;
};

}  // namespace trajan
