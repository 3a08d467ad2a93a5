#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solver/implicit/discretization.h"
#include "solver/implicit/mean_dilatation.h"
#include "solver/schemes/law_response.h"

namespace trajan {

/// What the materials answer to a displacement of the nodes, particle by particle.
class Responses {
 public:
  Responses(const Model& model, Executor& executor);

  struct Trouble {
    std::int64_t inverted = 0, unsolved = 0;
    std::int64_t body = -1;  ///< the first one of which there are such particles
    bool none() const { return inverted == 0 && unsolved == 0; }
  };
  /// From the particles' state; it lasts `dt`.
  Trouble evaluate(const Discretization& on, std::span<const double> displacement, double dt, bool with_tangents);
  /// Makes the end of the step the particles' state, their deformation gradient included if anybody wants it.
  void commit(const Discretization& on, std::span<const double> displacement, double dt);

  /// Particles times components of G.
  const std::vector<double>& forces() const { return forces_; }
  /// Particles times components times components.
  const std::vector<double>& tangents() const { return tangents_; }
  /// Adds to a matrix that has been assembled from them what the tangents of single particles do not tell.
  void add_stiffness(const Discretization& on, Eigen::SparseMatrix<double>& out) const {
    if (mean_dilatation_) mean_dilatation_->add_stiffness(on, out);
  }

 private:
  /// What laws feel of the displacement.
  const std::vector<double>& feel(const Discretization& on, std::span<const double> displacement);
  void find_gradients(const Discretization& on, std::span<const double> displacement, std::size_t first,
                      int count);

  Executor& executor_;
  std::vector<const LawResponseKernels*> laws_;      ///< by body
  std::unique_ptr<MeanDilatation> mean_dilatation_;  ///< if the scene asks for it
  std::vector<double> gradients_, forces_, tangents_;
};

}  // namespace trajan
