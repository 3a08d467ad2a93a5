#include "solver/implicit/newton_iterations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/implicit/reduction.h"

namespace trajan {
namespace {

/// Of the right-hand side, where linear systems are solved by iterations.
constexpr double linear_tolerance = 1e-10;
constexpr int most_halvings = 5;
constexpr int most_searches = 5;

}  // namespace

NewtonIterations::NewtonIterations(const Newton& options, SparseSolver& solver, StepBalance& balance)
    : options_(options),
      solver_(solver),
      balance_(balance),
      displacement_(Eigen::VectorXd::Zero(balance.constraints().expand().rows())) {
  if (!balance.trouble().none()) failure_ = Failure::no_answer;
}

NewtonIterations::State NewtonIterations::fail(Failure why) {
  failure_ = why;
  return State::failed;
}

NewtonIterations::State NewtonIterations::iterate() {
  if (failure_ != Failure::none) return State::failed;
  const SparseMatrix& expand = balance_.constraints().expand();
  solver_.release();
  SparseMatrix tangent = balance_.tangent();
  Eigen::VectorXd residual = balance_.residual();
  const bool first = residuals_.empty();
  if (first) {
    const Eigen::VectorXd prescribed = tangent * balance_.constraints().given();
    prescribed_scale_ = prescribed.norm();
    residual -= prescribed;
  }
  factors_ = solver_.factorize(reduced(std::move(tangent), expand), balance_.constraints().places());
  if (!factors_.regular) return fail(Failure::singular);
  const Eigen::VectorXd free = solver_.solve(expand.transpose() * residual, linear_tolerance);
  factors_ = solver_.factors();
  if (!factors_.regular) return fail(factors_.positive_definite ? Failure::unsolved : Failure::singular);
  if (!free.allFinite()) return fail(Failure::singular);
  Eigen::VectorXd direction = expand * free;
  if (first) direction += balance_.constraints().given();
  return advance(direction, free) ? judge() : fail(Failure::no_answer);
}

/// By inverse iteration, for which factors of a matrix that is singular but for rounding are good.
Eigen::VectorXd NewtonIterations::weakest() const {
  constexpr int rounds = 4;
  const SparseMatrix& expand = balance_.constraints().expand();
  Eigen::VectorXd free(expand.cols());
  for (Eigen::Index i = 0; i < free.size(); ++i) free[i] = 1 + std::sin(static_cast<double>(i));
  for (int round = 0; round < rounds; ++round) {
    const Eigen::VectorXd next = solver_.solve(free);
    if (!next.allFinite() || !(next.norm() > 0)) break;
    free = next / next.norm();
  }
  return expand * free;
}

Eigen::VectorXd NewtonIterations::missing() const {
  return balance_.constraints().expand() * balance_.reduced_residual();
}

double NewtonIterations::rounding(double cell) const {
  const double scale = std::max(balance_.scale(), prescribed_scale_);
  if (!(scale > 0)) return 0;
  const SparseMatrix tangent = balance_.tangent();
  const Eigen::VectorXd rows = tangent.cwiseAbs() * Eigen::VectorXd::Constant(tangent.cols(), cell);
  return std::numeric_limits<double>::epsilon() * rows.norm() / scale;
}

NewtonIterations::State NewtonIterations::judge() {
  const double norm = balance_.reduced_residual().norm(), scale = std::max(balance_.scale(), prescribed_scale_);
  residuals_.push_back(scale > 0 ? norm / scale : 0);
  if (residuals_.back() <= options_.tolerance) return State::converged;
  return iterations() < options_.most_iterations ? State::going : fail(Failure::too_slow);
}

/// The work of what is missing along the direction should become less. If it has become more, the next length is
/// where it vanishes on the line through its values at the ends (Crisfield 1991, section 9.2). The first iteration
/// is not shortened: where volume hardly changes it leaves an error of the second order in volume, whose forces
/// are large and which the next one takes back, while one that avoids such forces gets nowhere.
bool NewtonIterations::advance(const Eigen::VectorXd& direction, const Eigen::VectorXd& reduced) {
  const bool first = residuals_.empty(), whole_only = first && !balance_.constraints().homogeneous();
  const double before = reduced.dot(balance_.reduced_residual());
  double length = 1;
  for (int halvings = 0; !balance_.evaluate(displacement_ + length * direction); length *= 0.5)
    if (whole_only || ++halvings > most_halvings) return false;
  for (int search = 0; search < most_searches && !first; ++search) {
    const double after = reduced.dot(balance_.reduced_residual());
    if (std::abs(after) <= std::abs(before)) break;
    length *= std::clamp(before / (before - after), 0.1, 0.7);
    if (!balance_.evaluate(displacement_ + length * direction)) return false;
  }
  displacement_ += length * direction;
  return true;
}

}  // namespace trajan
