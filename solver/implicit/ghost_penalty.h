#pragma once

#include <cstdint>
#include <vector>

#include "solver/implicit/discretization.h"

namespace trajan {

/// Holds nodes that particles hardly reach to the polynomial that the nodes beside them go on with, so that
/// equations are well conditioned however the boundary cuts cells. For linear functions this is the ghost penalty
/// of Burman (2010) on the jump of normal derivatives across faces, which Coombs (2023, Int. J. Numer. Methods
/// Eng. 124) puts to use in the material point method, with the face integrals lumped at the nodes: a second
/// difference of nodal values along the face's normal is the jump times the cell size. Splines of degree p jump in
/// their p-th derivative, which is the difference of order p + 1; Bernstein elements jump in both of their
/// derivatives, and are held only along axes along which they are light. Only nodes with less than a share of
/// their volume inside a body are held, less than a body has whose faces lie on lines of the grid, so that nothing
/// is added where nothing is wrong.
class GhostPenalty {
 public:
  /// Holds nothing.
  GhostPenalty() = default;
  GhostPenalty(const Model& model, const Discretization& on);

  /// A sum of the nodes first, first + 1, ... along an axis, and the stiffness that its square has.
  struct Difference {
    std::vector<std::uint32_t> nodes;
    std::vector<double> coefficients;
    double stiffness;
  };
  const std::vector<Difference>& differences() const { return differences_; }

 private:
  std::vector<Difference> differences_;
};

}  // namespace trajan
