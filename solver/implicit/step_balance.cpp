#include "solver/implicit/step_balance.h"

namespace trajan {

StepBalance::StepBalance(const Model& model, Executor& executor, const GridView& view, Responses& responses,
                         double from, double to, double duration)
    : view_(view),
      responses_(responses),
      loads_(model, executor),
      from_(from),
      to_(to),
      duration_(duration),
      constraints_(view.on, executor, from, to) {
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(view.on.unknowns()));
  external_before_ = external_at(from, rest);
  evaluate(rest);
  internal_before_ = internal_;
}

Eigen::VectorXd StepBalance::external_at(double time, const Eigen::VectorXd& displacement,
                                         SparseMatrix* stiffness) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(displacement.size());
  loads_.add(view_.on, time, span_of(displacement), span_of(forces), stiffness);
  return forces;
}

void StepBalance::set_inertia(Inertia inertia) {
  inertia_ = std::move(inertia);
  evaluate(Eigen::VectorXd::Zero(displacement_.size()));
}

Eigen::VectorXd StepBalance::load_rate(double step) {
  return (external_at(to_ + step, displacement_) - external_at(to_ - step, displacement_)) / (2 * step);
}

bool StepBalance::evaluate(const Eigen::VectorXd& displacement) {
  displacement_ = displacement;
  trouble_ = responses_.evaluate(view_.on, span_of(displacement), duration_, true);
  if (!trouble_.none()) return false;
  internal_.setZero(displacement.size());
  view_.assembly.add_forces(responses_.forces(), span_of(displacement), span_of(internal_));
  external_ = external_at(to_, displacement);
  residual_ = inertia_.forces_share * (external_ - internal_);
  if (inertia_.mass) residual_ -= inertia_.of_displacement * (*inertia_.mass * displacement);
  if (inertia_.constant.size() > 0) residual_ += inertia_.constant;
  return residual_.allFinite();
}

double StepBalance::scale() const {
  return std::max({internal_.norm(), external_.norm(), internal_before_.norm(), external_before_.norm(),
                   inertia_.constant.size() > 0 ? inertia_.constant.norm() : 0.0});
}

SparseMatrix StepBalance::tangent() {
  SparseMatrix tangent;
  view_.assembly.stiffness(responses_.tangents(), tangent);
  responses_.add_stiffness(view_.on, tangent);
  if (loads_.follow()) external_at(to_, displacement_, &tangent);
  if (inertia_.forces_share != 1) tangent *= inertia_.forces_share;
  if (inertia_.mass)
    for (Eigen::Index e = 0; e < tangent.nonZeros(); ++e)
      tangent.valuePtr()[e] += inertia_.of_displacement * inertia_.mass->valuePtr()[e];
  return tangent;
}

/// By the trapezoidal rule. Reactions are what internal forces are more than external ones; elsewhere that is
/// what the grid's renewal has left unbalanced at the beginning, and not counted.
double StepBalance::work(const Eigen::VectorXd& displacement, const Eigen::VectorXd& before,
                         const Eigen::VectorXd& after) const {
  double work = 0.5 * (external_before_ + external_).dot(displacement);
  Eigen::VectorXd reaction = internal_before_ - external_before_ + internal_ - external_;
  if (before.size() > 0) reaction += before + after;
  std::vector<char> held(static_cast<std::size_t>(displacement.size()), 0);
  for (const Constraints::Row& row : constraints_.rows())
    for (const auto& [unknown, weight] : row.terms) held[unknown] = 1;
  for (Eigen::Index u = 0; u < displacement.size(); ++u)
    if (held[static_cast<std::size_t>(u)]) work += 0.5 * reaction[u] * displacement[u];
  return work;
}

}  // namespace trajan
