#pragma once

#include <memory>
#include <optional>

#include "solver/implicit/newton_iterations.h"
#include "solver/simulation/stepper.h"

namespace trajan {

/// Load steps of a quasi-static analysis; a Newton iteration is a piece of work.
class QuasiStaticSteps : public Stepper {
 public:
  QuasiStaticSteps(const Model& model, const QuasiStatic& analysis, Executor& executor, const Checkpoint* resume);

  bool advance(double until, std::int64_t number) override;
  double time() const override { return time_; }
  std::int64_t steps_left() const override;
  void save(Checkpoint& checkpoint) const override;

  /// Residuals of the last step's iterations.
  const std::vector<double>& residuals() const { return residuals_; }

 private:
  void begin(double until);
  void accept();
  void cut();
  void refuse_free_motion() const;
  [[noreturn]] void give_up() const;
  [[noreturn]] void diverge(const std::string& cause, const std::string& remedy) const;

  const Model& model_;
  const QuasiStatic& analysis_;
  Executor& executor_;
  bool total_lagrangian_;
  Responses responses_;
  SparseSolver solver_;
  std::unique_ptr<GridView> view_;
  std::optional<StepBalance> balance_;
  std::optional<NewtonIterations> newton_;
  double time_ = 0, length_;  ///< of the next step, if samples do not make it shorter
  int cuts_ = 0;              ///< in a row
  std::int64_t number_ = 0, load_steps_ = 0, iterations_ = 0;
  std::vector<double> residuals_;
  bool checked_ = false;  ///< whether the supports have been found to be enough
};

}  // namespace trajan
