#pragma once

#include <array>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "solver/materials/dimension.h"
#include "solver/materials/material.h"
#include "solver/materials/tensor_inverse.h"
#include "solver/materials/tensor_products.h"
#include "solver/schemes/kernels.h"
#include "solver/schemes/law_response.h"

namespace trajan::test {

/// In every dimension: what it does not have is 0, of a deformation gradient the identity.
using Matrix = Tensor<3>;
using Stress = SymmetricTensor<3>;

/// One law for one dimension and one configuration, as the registry lists it.
struct LawCase {
  const MaterialKind* kind;
  Dimension dimension;
  bool total_lagrangian;
};
std::ostream& operator<<(std::ostream&, const LawCase&);
std::string name_of(const LawCase&);
std::string name_of(Dimension);

/// All laws that are listed, for all dimensions and configurations that they are made for.
std::vector<LawCase> all_laws();
/// Those of them that are hyperelastic.
std::vector<LawCase> hyperelastic_laws();

/// What the moduli of all samples are below; rounding errors of stresses are relative to it.
inline constexpr double largest_modulus = 4000;
/// Sets of parameters to test a law with, in the order of its table. Throws if nobody has chosen any.
std::vector<std::vector<double>> sample_parameters(const MaterialKind&);
/// What a law can be expected to do beyond what all laws do.
struct LawTraits {
  bool hyperelastic = false;  ///< stress follows from an energy of the deformation gradient
  bool elastic = false;       ///< comes back from small strains, with the moduli of its wave speed
  bool hookean = false;       ///< the first two parameters are E and nu at small strain
  bool objective = true;      ///< turns with a rotation
  bool isotropic = true;
};
LawTraits traits_of(const MaterialKind&);

/// A particle of volume 1 and this density that only a law acts on: the kernels of the registry on a block
/// of one, without a grid.
class MaterialPoint {
 public:
  MaterialPoint(const LawCase&, const std::vector<double>& parameters, double density = 1);

  /// Brings the deformation gradient to `next` in one step, of which only what the dimension has is looked at.
  void deform(const Matrix& next);
  /// The step to that deformation gradient, as components of its displacement gradient in their order.
  std::vector<double> step_to(const Matrix& next) const;
  struct StepResponse {
    std::vector<double> force, tangent;  ///< n and n x n
    std::int64_t inverted, unsolved;
  };
  StepResponse respond(const std::vector<double>& step) const;
  void commit(const std::vector<double>& step);

  /// Without the stretches that the law itself finds.
  const Matrix& deformation() const { return deformation_; }
  std::int64_t inverted() const { return scratch_->trouble.inverted; }
  std::int64_t unsolved() const { return scratch_->trouble.unsolved; }

  /// Cauchy.
  Stress stress() const;
  /// V sigma = P F^T, from the force that the particle gives to the grid.
  Matrix virial() const;
  /// First Piola-Kirchhoff stress.
  Matrix nominal_stress() const;
  double energy() const;
  /// Square of the fastest wave's speed, in the configuration of the law's case.
  double squared_wave_speed() const;

 private:
  Block block() const;
  int axes() const { return grid_axes(of_.dimension); }
  /// The displacement gradient of a step with respect to the configuration of the law's case.
  Matrix gradient_to(const Matrix& next) const;

  LawCase of_;
  const LawKernels* kernels_;
  const LawResponseKernels* response_kernels_;
  std::shared_ptr<const void> law_;
  BodyConstants body_;
  SweepConstants sweep_;
  /// Stages may read and write a few entries past the last particle.
  mutable std::array<std::array<double, 1 + block_padding>, attribute_count> state_{};
  std::shared_ptr<Scratch> scratch_;
  Matrix deformation_ = identity<3>();
};

/// Row by row.
Matrix matrix(const std::array<double, 9>& rows);
/// Of a matrix what a dimension has, of the rest the identity's.
Matrix in(Dimension, const Matrix&);
/// Whether component (i, j) belongs to forces and motions of a dimension.
bool has(Dimension, int i, int j);
/// A rotation about z in a plane, about a skew axis in space; bars and meridian planes do not turn.
Matrix rotation(Dimension, double angle);
bool turns(Dimension);
/// Of all components.
double contraction(const Matrix&, const Matrix&);
double largest_difference(const Stress&, const Stress&);

}  // namespace trajan::test
