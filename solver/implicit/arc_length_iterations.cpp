#include "solver/implicit/arc_length_iterations.h"

#include <cmath>

#include "solver/implicit/reduction.h"

namespace trajan {
namespace {

/// Of the first load's time, in differences of loads.
constexpr double load_difference = 1e-5;

}  // namespace

ArcLengthIterations::ArcLengthIterations(const Newton& options, SparseSolver& solver, StepBalance& balance,
                                         const Path& path, double first_load)
    : NewtonIterations(options, solver, balance),
      before_(path),
      first_load_(first_load),
      load_time_(path.load_time),
      length_per_time_(path.length_per_time),
      free_(Eigen::VectorXd::Zero(balance.constraints().expand().cols())) {}

NewtonIterations::State ArcLengthIterations::iterate() {
  if (failure_ != Failure::none) return State::failed;
  const SparseMatrix& expand = balance_.constraints().expand();
  factors_ = solver_.factorize(reduced(balance_.tangent(), expand), balance_.constraints().places());
  if (!factors_.regular) return fail(Failure::singular);
  const Eigen::VectorXd by_load =
      solver_.solve(expand.transpose() * balance_.load_rate(load_difference * first_load_));
  factors_ = solver_.factors();
  if (!factors_.regular) return fail(factors_.positive_definite ? Failure::unsolved : Failure::singular);
  if (!by_load.allFinite()) return fail(Failure::singular);
  if (!(by_load.norm() > 0)) return fail(Failure::no_load);
  if (residuals_.empty()) {
    if (length_per_time_ == 0) length_per_time_ = first_load_ * by_load.norm() / balance_.duration();
    length_ = length_per_time_ * balance_.duration();
    const bool forwards = before_.direction.size() == 0 || before_.direction.dot(by_load) > 0;
    const double load = (forwards ? 1 : -1) * length_ / by_load.norm();
    free_ = load * by_load;
    load_time_ += load;
  } else if (!correct(solver_.solve(balance_.reduced_residual()), by_load)) {
    return fail(Failure::too_slow);
  }
  displacement_ = expand * free_;
  balance_.set_end(load_time_);
  if (!balance_.evaluate(displacement_)) return fail(Failure::no_answer);
  return judge();
}

/// |free + by_residual + load by_load| = length.
bool ArcLengthIterations::correct(const Eigen::VectorXd& by_residual, const Eigen::VectorXd& by_load) {
  const Eigen::VectorXd moved = free_ + by_residual;
  const double a = by_load.squaredNorm(), b = by_load.dot(moved), c = moved.squaredNorm() - length_ * length_;
  const double root = b * b - a * c;
  if (!(root >= 0)) return false;
  const double loads[] = {(-b + std::sqrt(root)) / a, (-b - std::sqrt(root)) / a};
  const double along = free_.dot(by_load);
  const double load = loads[0] * along > loads[1] * along ? loads[0] : loads[1];
  free_ = moved + load * by_load;
  load_time_ += load;
  return true;
}

}  // namespace trajan
