#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "solver/implicit/discretization.h"
#include "solver/schemes/volume_sharing.h"

namespace trajan {

/// The locking remedy "mean_dilatation": the laws of a cell's particles feel the mean of their volume ratios, so
/// that a cell is one constraint of volume, and not every particle. The mean is weighted by volume, and forces and
/// tangents derive from the energy that the laws have then (Simo, Taylor and Pister 1985): symmetric, if laws are
/// hyperelastic, unlike those of F-bar, whose forces derive from no energy (de Souza Neto, Peric, Dutko and Owen
/// 1996; in the material point method Coombs, Charlton, Cortis and Augarde 2018). Finite laws in total Lagrangian
/// analyses share the ratio to the state at rest, others that of each step.
///
/// A particle's force depends on others of its cell through the mean alone: besides the tangents of particles
/// there is a matrix of low rank for each cell.
class MeanDilatation {
 public:
  MeanDilatation(const Model& model, Executor& executor);

  /// What laws are to be asked for instead of these displacement gradients of a step
  /// (solver/schemes/law_response.h).
  const std::vector<double>& felt(const Discretization& on, const std::vector<double>& gradients);
  /// Makes of forces and tangents of what has last been felt those of the gradients.
  void pull(const Discretization& on, std::vector<double>& forces, std::vector<double>& tangents);
  /// Adds what the last pull has found for cells, to a matrix whose pattern joins the nodes of each particle.
  void add_stiffness(const Discretization& on, Eigen::SparseMatrix<double>& out) const;
  /// After laws have taken for their state what they have last felt: keeps what they have not been told.
  void commit(const Discretization& on);

 private:
  struct Particle {
    bool linear = false;  ///< geometrically
    double factor = 1;    ///< solver/schemes/volume_sharing.h
    double weight = 0;
    double ratio = 1;
  };
  struct Shared {
    double weight = 0, ratio = 0;
    double curvature = 0;  ///< second derivative of the energy by the shared ratio
  };
  template <Dimension D>
  void read_state(Block& block, std::size_t first, const Body& body);
  template <Dimension D>
  void share(const Discretization& on, std::size_t cell, const std::vector<double>& gradients);
  template <Dimension D>
  void pull_cell(const Discretization& on, std::size_t cell, std::vector<double>& forces,
                 std::vector<double>& tangents);
  /// Calls of.operator()<D>(cell), each on some thread.
  template <class Of>
  void for_each_cell(const Discretization& on, Of&& of) {
    executor_.pool().run([&](int thread) {
      const auto t = static_cast<std::size_t>(thread), threads = static_cast<std::size_t>(executor_.pool().size());
      const std::size_t first = on.cells() * t / threads, end = on.cells() * (t + 1) / threads;
      in_volume_dimension(model_.dimension, [&]<Dimension D>() {
        for (std::size_t c = first; c < end; ++c) of.template operator()<D>(c);
      });
    });
  }

  const Model& model_;
  Executor& executor_;
  bool total_lagrangian_;
  std::vector<Particle> particles_;
  std::vector<Shared> shared_;  ///< by cell
  /// By particle: H at the beginning of the step, what the law takes for it, H at the end, and the gradient that
  /// the law feels.
  std::vector<double> start_, stored_, end_, felt_;
  /// By node of a cell and axis: derivative of the shared ratio; of the forces by the shared ratio; of the
  /// energy's derivative by the shared ratio.
  std::vector<double> ratio_slopes_, couplings_, counter_couplings_;
};

}  // namespace trajan
