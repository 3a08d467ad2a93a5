#include "solver/implicit/arc_length_steps.h"

#include "solver/simulation/checkpoint_array.h"

namespace trajan {
namespace {

constexpr const char* state_name = "path";
constexpr const char* direction_name = "path_direction";

}  // namespace

ArcLengthSteps::ArcLengthSteps(const Model& model, const QuasiStatic& analysis, Executor& executor,
                               const Checkpoint* resume)
    : ImplicitSteps(model, executor, analysis.newton, analysis.arc_length->steps, resume),
      end_time_(model.end_time),
      first_load_(model.end_time / analysis.load_steps) {
  if (!resume) return;
  const auto& state = checkpoint_array<double>(*resume, state_name);
  path_.load_time = state[0];
  path_.length_per_time = state[1];
  const auto& direction = checkpoint_array<double>(*resume, direction_name);
  path_.direction =
      Eigen::Map<const Eigen::VectorXd>(direction.data(), static_cast<Eigen::Index>(direction.size()));
}

void ArcLengthSteps::save(Checkpoint& checkpoint) const {
  ImplicitSteps::save(checkpoint);
  checkpoint.arrays.push_back({state_name, std::vector<double>{path_.load_time, path_.length_per_time}});
  checkpoint.arrays.push_back(
      {direction_name, std::vector<double>(path_.direction.begin(), path_.direction.end())});
}

void ArcLengthSteps::record(std::vector<double>& columns) const { columns.push_back(path_.load_time / end_time_); }

std::unique_ptr<StepBalance> ArcLengthSteps::make_balance(double from, double to) {
  return balance_between(path_.load_time, path_.load_time, to - from);
}

std::unique_ptr<NewtonIterations> ArcLengthSteps::make_iterations(StepBalance& balance) {
  auto made = std::make_unique<ArcLengthIterations>(options(), solver(), balance, path_, first_load_);
  present_ = made.get();
  return made;
}

std::string ArcLengthSteps::where() const {
  return "the load factor " + std::to_string(path_.load_time / end_time_);
}

void ArcLengthSteps::end_step(const StepBalance& balance, const Eigen::VectorXd& displacement) {
  ImplicitSteps::end_step(balance, displacement);
  path_ = present_->path();
}

}  // namespace trajan
