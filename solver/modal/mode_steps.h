#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>

#include "solver/implicit/quasi_static_steps.h"
#include "solver/modal/eigenmodes.h"
#include "solver/simulation/stepper.h"

namespace trajan {

/// An eigenvalue problem of a body's discretization, solved for free unknowns.
struct ModeProblem {
  SparseMatrix stiffness;
  SparseMatrix other;   ///< mass, or the change of the stiffness by the loads
  SparseMatrix expand;  ///< free unknowns to all unknowns
};

/// Finds modes of a state and shows one after the other: at sample i the particles are displaced by the i-th mode,
/// scaled so that the largest displacement is a twentieth of the bodies' extent. The search goes on in a thread
/// of its own, so that a run can be stopped at any moment.
class ModeSteps : public Stepper {
 public:
  /// lowest_modes or critical_factors.
  using Solve = std::vector<Eigenmode> (*)(const SparseMatrix&, const SparseMatrix&, int, const Interruption&);
  ModeSteps(const Model& model, Solve solve, Executor& executor, const Checkpoint* resume);
  ~ModeSteps() override;

  bool advance(double until, std::int64_t number) override;
  double time() const override;
  std::int64_t steps_left() const override;
  void record(std::vector<double>& columns) const override;
  void save(Checkpoint& checkpoint) const override;

 protected:
  /// Does a piece of what must be done before; true: nothing is left of it.
  virtual bool prepare(std::int64_t number) = 0;
  virtual ModeProblem make_problem(const GridView& view) = 0;
  /// Appends the columns of a mode, zeros of none.
  virtual void describe(const Eigenmode* mode, std::vector<double>& columns) const = 0;
  [[noreturn]] void diverge(const std::string& cause, const std::string& remedy) const;

  const Model& model_;
  Executor& executor_;
  Responses responses_;

 private:
  void start();
  void finish();
  void show(const Eigenmode& mode);
  /// Calls of(number in the order of blocks, axis, coordinate) for all particles.
  template <class Of>
  void for_each_coordinate(Of&& of);

  Solve solve_;
  int count_, shown_ = 0;
  std::int64_t number_ = 0;
  std::unique_ptr<GridView> view_;
  SparseMatrix expand_;
  double extent_ = 0;
  std::vector<double> base_;  ///< coordinates of particles without a mode
  std::vector<Eigenmode> modes_;
  std::atomic<bool> stopped_ = false;
  std::future<std::vector<Eigenmode>> search_;
};

/// Free vibrations about the state under the model's loads.
class ModalSteps : public ModeSteps {
 public:
  ModalSteps(const Model& model, const Modal& analysis, Executor& executor, const Checkpoint* resume);

 protected:
  bool prepare(std::int64_t number) override;
  ModeProblem make_problem(const GridView& view) override;
  void describe(const Eigenmode* mode, std::vector<double>& columns) const override;

 private:
  bool lumped_;
  const QuasiStatic preloading_{};
  std::optional<QuasiStaticSteps> preload_;
  SparseMatrix momenta_;  ///< one column per axis: momenta of free unknowns when the whole body moves along it
  double total_mass_ = 0;
};

/// Factors of the model's loads under which equilibrium branches, by the derivative of the tangent along the
/// linear answer to the loads.
class BucklingSteps : public ModeSteps {
 public:
  BucklingSteps(const Model& model, Executor& executor, const Checkpoint* resume);

 protected:
  bool prepare(std::int64_t) override { return true; }
  ModeProblem make_problem(const GridView& view) override;
  void describe(const Eigenmode* mode, std::vector<double>& columns) const override;
};

}  // namespace trajan
