#pragma once

#include <cmath>

#include "solver/executors/block.h"
#include "solver/materials/plane_tensor.h"
#include "solver/scene/scene.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Squares of the principal stretches of F: the eigenvalues of F F^T, the larger one first.
struct PrincipalStretches {
  double largest, smallest;
  explicit PrincipalStretches(const PlaneTensor<double>& f) {
    const double mean = 0.5 * (f.xx * f.xx + f.xy * f.xy + f.yx * f.yx + f.yy * f.yy);
    const double j = determinant(f);
    const double rest = mean * mean - j * j;
    const double root = rest > 0 ? std::sqrt(rest) : 0;
    largest = mean + root;
    smallest = j * j / largest;
  }
};

/// Pointers to the state, and access to it by particle.
template <Dimension D>
struct LawState {
  double *sxx, *syy, *sxy, *szz, *volume, *fxx, *fxy, *fyx, *fyy;
  explicit LawState(const Block& b)
      : sxx(b[Attribute::stress_xx]),
        syy(b[Attribute::stress_yy]),
        sxy(b[Attribute::stress_xy]),
        szz(b[Attribute::stress_zz]),
        volume(b[Attribute::volume]),
        fxx(b[Attribute::deformation_xx]),
        fxy(b[Attribute::deformation_xy]),
        fyx(b[Attribute::deformation_yx]),
        fyy(b[Attribute::deformation_yy]) {}
  SymmetricTensor<double> stress(int i) const {
    return {sxx[i], syy[i], sxy[i], D == Dimension::plane_strain ? szz[i] : 0.0};
  }
  PlaneTensor<double> deformation(int i) const { return {fxx[i], fxy[i], fyx[i], fyy[i]}; }
  void set_stress(int i, const SymmetricTensor<double>& s) const {
    sxx[i] = s.xx;
    syy[i] = s.yy;
    sxy[i] = s.xy;
    if constexpr (D == Dimension::plane_strain) szz[i] = s.zz;
  }
  void set_deformation(int i, const PlaneTensor<double>& f) const {
    fxx[i] = f.xx;
    fxy[i] = f.xy;
    fyx[i] = f.yx;
    fyy[i] = f.yy;
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
