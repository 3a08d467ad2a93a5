#include "server/convert_parts.h"

namespace trajan {
namespace {

LinearSolver to_linear_solver(int value) {
  switch (value) {
    case v1::Newton::LINEAR_SOLVER_UNSPECIFIED:
    case v1::Newton::AUTOMATIC:
      return LinearSolver::automatic;
    case v1::Newton::DIRECT:
      return LinearSolver::direct;
    case v1::Newton::ITERATIVE:
      return LinearSolver::iterative;
    default:
      return LinearSolver::unspecified;
  }
}

MassMatrix to_mass_matrix(int value) {
  switch (value) {
    case v1::MASS_MATRIX_UNSPECIFIED:
    case v1::CONSISTENT:
      return MassMatrix::consistent;
    case v1::LUMPED:
      return MassMatrix::lumped;
    default:
      return MassMatrix::unspecified;
  }
}

Newton to_newton(const v1::Newton& message) {
  Newton newton;
  if (message.has_tolerance()) newton.tolerance = message.tolerance();
  if (message.has_most_iterations()) newton.most_iterations = message.most_iterations();
  if (message.has_most_cuts()) newton.most_cuts = message.most_cuts();
  if (message.has_growth()) newton.growth = message.growth();
  newton.linear_solver = to_linear_solver(message.linear_solver());
  return newton;
}

Relaxation to_relaxation(const v1::Relaxation& message) {
  Relaxation analysis;
  if (message.has_tolerance()) analysis.tolerance = message.tolerance();
  if (message.has_most_steps()) analysis.most_steps = message.most_steps();
  return analysis;
}

QuasiStatic to_quasi_static(const v1::QuasiStatic& message) {
  QuasiStatic analysis;
  if (message.has_load_steps()) analysis.load_steps = message.load_steps();
  analysis.newton = to_newton(message.newton());
  if (message.has_arc_length()) analysis.arc_length.emplace();
  if (message.arc_length().has_steps()) analysis.arc_length->steps = message.arc_length().steps();
  return analysis;
}

ImplicitDynamics to_implicit_dynamics(const v1::ImplicitDynamics& message) {
  ImplicitDynamics analysis;
  if (message.has_time_steps()) analysis.time_steps = message.time_steps();
  analysis.newton = to_newton(message.newton());
  if (message.has_newmark()) {
    Newmark& newmark = analysis.method.emplace<Newmark>();
    if (message.newmark().has_beta()) newmark.beta = message.newmark().beta();
    if (message.newmark().has_gamma()) newmark.gamma = message.newmark().gamma();
  }
  if (message.generalized_alpha().has_spectral_radius())
    analysis.method = GeneralizedAlpha{message.generalized_alpha().spectral_radius()};
  analysis.mass = to_mass_matrix(message.mass());
  return analysis;
}

AnalysisKind to_kind(const v1::Analysis& message) {
  switch (message.kind_case()) {
    case v1::Analysis::kRelaxation:
      return to_relaxation(message.relaxation());
    case v1::Analysis::kQuasiStatic:
      return to_quasi_static(message.quasi_static());
    case v1::Analysis::kImplicitDynamics:
      return to_implicit_dynamics(message.implicit_dynamics());
    case v1::Analysis::kModal:
      return Modal{to_mass_matrix(message.modal().mass())};
    case v1::Analysis::kBuckling:
      return Buckling{};
    case v1::Analysis::kExplicitDynamics:
    case v1::Analysis::KIND_NOT_SET:
      break;
  }
  return ExplicitDynamics{};
}

}  // namespace

Analysis to_analysis(const v1::Analysis& message) {
  return {message.end_time(), message.damping(), to_kind(message)};
}

}  // namespace trajan
