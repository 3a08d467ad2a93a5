#pragma once

#include <array>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "solver/materials/material.h"
#include "solver/materials/plane_tensor.h"
#include "solver/schemes/kernels.h"

namespace trajan::test {

using Tensor = PlaneTensor<double>;

/// One law for one dimension and one configuration, as the registry lists it.
struct LawCase {
  const MaterialKind* kind;
  Dimension dimension;
  bool total_lagrangian;
};
std::ostream& operator<<(std::ostream&, const LawCase&);
std::string name_of(const LawCase&);

/// All laws that are listed, for both dimensions and both configurations.
std::vector<LawCase> all_laws();
/// Those of them whose stress follows from an energy of the deformation gradient.
std::vector<LawCase> hyperelastic_laws();

/// Sets of parameters to test a law with, in the order of its table. Throws if a law has a parameter that
/// nobody has chosen values for.
std::vector<std::vector<double>> sample_parameters(const MaterialKind&);
/// The value of the parameter of this name.
double value_of(const MaterialKind&, const std::vector<double>& parameters, std::string_view name);

/// A particle of volume 1 and this density that only a law acts on: the kernels of the registry on a block
/// of one, without a grid.
class MaterialPoint {
 public:
  MaterialPoint(const LawCase&, const std::vector<double>& parameters, double density = 1);

  /// Brings the deformation gradient to `next` in one step.
  void deform(const Tensor& next);
  const Tensor& deformation() const { return deformation_; }
  /// Deformations that lost their positive determinant, so far.
  std::int64_t inverted() const { return scratch_->trouble.inverted; }

  /// Cauchy: xx, yy, xy, zz.
  std::array<double, 4> stress() const;
  /// V sigma = P F^T in plane components, from the force that the particle gives to the grid.
  Tensor virial() const;
  /// First Piola-Kirchhoff stress.
  Tensor nominal_stress() const;
  double energy() const;
  /// Square of the fastest wave's speed, in the configuration of the law's case.
  double squared_wave_speed() const;

 private:
  Block block() const;

  LawCase of_;
  const LawKernels* kernels_;
  std::shared_ptr<const void> law_;
  BodyConstants body_;
  SweepConstants sweep_;
  /// Stages may read and write a few entries past the last particle.
  mutable std::array<std::array<double, 1 + block_padding>, attribute_count> state_{};
  std::shared_ptr<Scratch> scratch_;
  Tensor deformation_{1, 0, 0, 1};
};

inline Tensor transpose(const Tensor& a) { return {a.xx, a.yx, a.xy, a.yy}; }
inline Tensor operator+(const Tensor& a, const Tensor& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.yx + b.yx, a.yy + b.yy};
}
inline Tensor operator-(const Tensor& a, const Tensor& b) {
  return {a.xx - b.xx, a.xy - b.xy, a.yx - b.yx, a.yy - b.yy};
}
inline double contraction(const Tensor& a, const Tensor& b) {
  return a.xx * b.xx + a.xy * b.xy + a.yx * b.yx + a.yy * b.yy;
}
Tensor rotation(double angle);

}  // namespace trajan::test
