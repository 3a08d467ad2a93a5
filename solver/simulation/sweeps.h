#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solver/simulation/particles.h"
#include "solver/simulation/pass.h"
#include "solver/transfers/transfer.h"

namespace trajan {

/// One way through the particles: a chain of passes, resolved to stages for every body.
struct Sweep {
  std::vector<Pass> passes;
  unsigned mask = 0;                       ///< node quantities that are gathered
  int first_sum = 0, sums = 0;             ///< sums that are scattered
  std::vector<std::vector<Stage>> stages;  ///< by body
  std::int64_t runs = 0;                   ///< how often it has been made
};

/// What passes over particles do in a model, and the sweeps that have been asked for so far.
class Sweeps {
 public:
  /// `sum_quantities`: all that particles scatter.
  Sweeps(const Model& model, const Transfer& kind, const TransferKernels& transfer, int sum_quantities);

  /// The sweep of these passes, resolved when it is first asked for.
  Sweep& of(std::span<const Pass> passes, const std::vector<BodyParticles>& bodies);
  /// From now on with these kernels, of the same shape functions: all sweeps stay where they are.
  void use(const TransferKernels& transfer, const std::vector<BodyParticles>& bodies);
  /// In the order in which they were first asked for.
  std::span<const std::unique_ptr<Sweep>> all() const { return sweeps_; }
  /// What a stage of this body does, for people.
  std::string name(Stage stage, const BodyParticles& body, std::size_t index) const;
  const TransferPasses& transfer_passes() const { return transfer_passes_; }

 private:
  void resolve(Sweep& sweep, const std::vector<BodyParticles>& bodies) const;
  /// What a pass does to the particles of a body, one stage after the other.
  std::vector<Stage> stages_of(Pass pass, const BodyParticles& body, std::size_t index) const;
  std::vector<Stage> deform_stages(const BodyParticles& body, std::size_t index) const;
  Stage sharing(std::size_t body) const;
  /// What finds the shape functions at a particle before these passes.
  Stage locating(std::span<const Pass> next) const;
  /// Whether shape functions at a particle are others after a pass.
  bool relocates(Pass pass) const;
  /// Bits of the node vectors that a pass gathers.
  unsigned gathered(Pass pass) const;

  const Model& model_;
  int axes_;  ///< of the grid
  const MotionKernels& motion_;
  const Transfer& kind_;
  const TransferKernels* transfer_;
  TransferPasses transfer_passes_;
  int sum_quantities_;
  bool loads_;
  std::vector<std::unique_ptr<Sweep>> sweeps_;
};

}  // namespace trajan
