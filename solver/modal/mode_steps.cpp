#include "solver/modal/mode_steps.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "solver/schemes/scheme.h"
#include "solver/simulation/checkpoint_array.h"
#include "solver/simulation/diverged.h"

namespace trajan {
namespace {

/// Largest displacement of a mode that is shown, as a share of the diagonal of the box around all particles.
constexpr double shown_share = 0.05;
constexpr std::chrono::milliseconds patience{40};
constexpr const char* state_name = "particles_without_mode";

/// Ends the search in its thread.
struct Stopped {};

/// What skew parts do to the lowest values is of second order in them.
void drop_skew_part(SparseMatrix& matrix) {
  const SparseMatrix transposed = matrix.transpose();
  matrix = 0.5 * (matrix + transposed);
}

}  // namespace

ModeSteps::ModeSteps(const Model& model, Solve solve, Executor& executor, const Checkpoint* resume)
    : model_(model),
      executor_(executor),
      responses_(model, executor),
      solve_(solve),
      count_(static_cast<int>(model.outputs.samples)) {
  if (!resume) return;
  shown_ = static_cast<int>(resume->sample);
  base_ = checkpoint_array<double>(*resume, state_name);
  for_each_coordinate([&](std::size_t at, double& coordinate) { coordinate = base_[at]; });
}

ModeSteps::~ModeSteps() {
  stopped_ = true;
  if (search_.valid()) search_.wait();
}

template <class Of>
void ModeSteps::for_each_coordinate(Of&& of) {
  const bool total = is_total_lagrangian(model_.numerics.scheme);
  const Attribute first = total ? Attribute::displacement_x : Attribute::position_x;
  const auto axes = static_cast<std::size_t>(grid_axes(model_.dimension));
  std::size_t particle = 0;
  for (const BlockRange& block : executor_.tiles().blocks())
    for (std::size_t i = block.begin; i < block.begin + block.count; ++i, ++particle)
      for (std::size_t axis = 0; axis < axes; ++axis)
        of(particle * axes + axis, executor_.bodies()[block.body].component(first, static_cast<int>(axis))[i]);
}

bool ModeSteps::advance(double, std::int64_t number) {
  // How often one looks whether the search is over is chance.
  if (!search_.valid()) number_ = number;
  try {
    if (modes_.empty()) {
      if (!search_.valid() && !prepare(number)) return false;
      if (!search_.valid()) start();
      if (search_.wait_for(patience) != std::future_status::ready) return false;
      finish();
    }
    show(modes_[static_cast<std::size_t>(shown_)]);
  } catch (const FormulaNotFinite& error) {
    diverge(error.what(), "give a formula that is finite throughout the run");
  } catch (const NoModes& error) {
    diverge(error.what(), "check boundaries and loads: the state of which modes are asked must be stable");
  }
  ++shown_;
  return true;
}

void ModeSteps::start() {
  view_ = std::make_unique<GridView>(model_, executor_);
  const bool resumed = !base_.empty();
  if (!resumed) {
    base_.resize(view_->on.particles() * static_cast<std::size_t>(view_->on.axes()));
    for_each_coordinate([&](std::size_t at, double& coordinate) { base_[at] = coordinate; });
  }
  ModeProblem problem = make_problem(*view_);
  drop_skew_part(problem.stiffness);
  drop_skew_part(problem.other);
  expand_ = problem.expand;
  search_ = std::async(std::launch::async, [this, problem = std::move(problem)] {
    return solve_(problem.stiffness, problem.other, count_, [this] {
      if (stopped_) throw Stopped{};
    });
  });
}

void ModeSteps::finish() {
  modes_ = search_.get();
  if (static_cast<int>(modes_.size()) < count_)
    diverge("there are only " + std::to_string(modes_.size()) + " modes", "ask for no more, or take a finer grid");
  const auto axes = static_cast<std::size_t>(view_->on.axes());
  double squares = 0;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    double lowest = HUGE_VAL, highest = -HUGE_VAL;
    for (const BodyParticles& body : executor_.bodies())
      for (double x : body.component(Attribute::position_x, static_cast<int>(axis)))
        lowest = std::min(lowest, x), highest = std::max(highest, x);
    squares += (highest - lowest) * (highest - lowest);
  }
  extent_ = std::sqrt(squares);
}

/// The largest component points along its axis.
void ModeSteps::show(const Eigenmode& mode) {
  const Eigen::VectorXd nodes = expand_ * mode.shape;
  const auto axes = static_cast<std::size_t>(view_->on.axes());
  std::vector<double> shape(base_.size(), 0.0);
  double largest = 0, squared = 0;
  for (std::size_t p = 0; p < view_->on.particles(); ++p) {
    const Discretization::Particle particle = view_->on.particle(p);
    double square = 0;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      double& u = shape[p * axes + axis];
      for (std::size_t n = 0; n < particle.nodes.size(); ++n)
        u += particle.weights[n] * nodes[static_cast<Eigen::Index>(particle.nodes[n] * axes + axis)];
      if (std::abs(u) > std::abs(largest) * (1 + 1e-9)) largest = u;
      square += u * u;
    }
    squared = std::max(squared, square);
  }
  const double scale = std::copysign(shown_share * extent_ / std::sqrt(squared), largest);
  for_each_coordinate([&](std::size_t at, double& coordinate) { coordinate = base_[at] + scale * shape[at]; });
}

double ModeSteps::time() const { return model_.end_time * shown_ / count_; }

std::int64_t ModeSteps::steps_left() const { return count_ - shown_; }

void ModeSteps::record(std::vector<double>& columns) const {
  describe(shown_ > 0 && !modes_.empty() ? &modes_[static_cast<std::size_t>(shown_ - 1)] : nullptr, columns);
}

void ModeSteps::save(Checkpoint& checkpoint) const { checkpoint.arrays.push_back({state_name, base_}); }

void ModeSteps::diverge(const std::string& cause, const std::string& remedy) const {
  throw Diverged({number_, time(), -1, cause, remedy});
}

}  // namespace trajan
