#pragma once

#include <memory>
#include <string>

#include "solver/implicit/newton_iterations.h"
#include "solver/simulation/stepper.h"

namespace trajan {

/// Steps that end in balance, each found by Newton's method; an iteration is a piece of work. A step that does not
/// converge is halved, and the following ones grow again.
class ImplicitSteps : public Stepper {
 public:
  /// `steps` of equal length as long as nothing is in the way.
  ImplicitSteps(const Model& model, Executor& executor, const Newton& newton, int steps, const Checkpoint* resume);

  bool advance(double until, std::int64_t number) override;
  double time() const override { return time_; }
  std::int64_t steps_left() const override;
  void save(Checkpoint& checkpoint) const override;

  /// Residuals of the last step's iterations.
  const std::vector<double>& residuals() const { return residuals_; }

 protected:
  bool total_lagrangian() const { return total_lagrangian_; }
  Executor& executor() { return executor_; }
  const Executor& executor() const { return executor_; }
  const GridView& view() const { return *view_; }
  const Newton& options() const { return options_; }
  SparseSolver& solver() { return solver_; }
  /// With loads and prescribed motions between two times, and a duration for the materials.
  std::unique_ptr<StepBalance> balance_between(double from, double to, double duration);
  /// Before particles move. Adds to the executor's energies and reactions.
  virtual void end_step(const StepBalance& balance, const Eigen::VectorXd& displacement);

 private:
  /// Of a step between two times.
  virtual std::unique_ptr<StepBalance> make_balance(double from, double to);
  virtual std::unique_ptr<NewtonIterations> make_iterations(StepBalance& balance);
  /// Before a step's first iteration.
  virtual void begin_step(StepBalance&) {}
  /// How far it has got, in words.
  virtual std::string where() const;
  /// Whether bodies must be held.
  virtual bool needs_supports() const { return true; }

  void begin(double until);
  void accept();
  void cut();
  void refuse_free_motion() const;
  [[noreturn]] void give_up() const;
  /// What is known of a balance that is not found.
  [[noreturn]] void give_up_on_balance(const std::string& beyond) const;
  [[noreturn]] void diverge(const std::string& cause, const std::string& remedy) const;

  const Model& model_;
  Executor& executor_;
  const Newton& options_;
  double longest_, shortest_;  ///< steps
  bool total_lagrangian_;
  Responses responses_;
  SparseSolver solver_;
  std::unique_ptr<GridView> view_;
  std::unique_ptr<StepBalance> balance_;
  std::unique_ptr<NewtonIterations> newton_;
  double time_ = 0, next_ = 0;  ///< before and after the present step
  double sample_ = -1;          ///< time of the next sample
  double length_;               ///< of the next step, if samples do not make it shorter
  int cuts_ = 0;                ///< in a row
  double out_of_reach_ = 0;     ///< time up to which the last step that was cut would have gone
  std::int64_t number_ = 0, steps_ = 0, iterations_ = 0;
  std::vector<double> residuals_;
};

}  // namespace trajan
