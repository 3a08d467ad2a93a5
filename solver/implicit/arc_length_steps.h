#pragma once

#include "solver/implicit/arc_length_iterations.h"
#include "solver/implicit/implicit_steps.h"

namespace trajan {

/// Steps of equal length along a path of equilibria. The time of the run counts them; that of the loads is found.
class ArcLengthSteps : public ImplicitSteps {
 public:
  ArcLengthSteps(const Model& model, const QuasiStatic& analysis, Executor& executor, const Checkpoint* resume);
  void save(Checkpoint& checkpoint) const override;
  void record(std::vector<double>& columns) const override;

 private:
  std::unique_ptr<StepBalance> make_balance(double from, double to) override;
  std::unique_ptr<NewtonIterations> make_iterations(StepBalance& balance) override;
  std::string where() const override;
  void end_step(const StepBalance& balance, const Eigen::VectorXd& displacement) override;

  double end_time_, first_load_;
  Path path_;
  const ArcLengthIterations* present_ = nullptr;  ///< of the present step
};

}  // namespace trajan
