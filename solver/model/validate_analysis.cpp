#include "solver/model/names.h"
#include "solver/model/validator.h"

namespace trajan {

void Validator::check_analysis() {
  clock_complete_ = violations_.positive("analysis.end_time", scene_.analysis.end_time);
  violations_.not_negative("analysis.damping", scene_.analysis.damping);
  model_.end_time = scene_.analysis.end_time;
  model_.damping = scene_.analysis.damping;
  model_.analysis = scene_.analysis.kind;
  std::visit([this](const auto& kind) { check_kind(kind); }, scene_.analysis.kind);
}

void Validator::check_newton(const std::string& path, const Newton& newton) {
  violations_.within(path + ".tolerance", newton.tolerance, 1e-14, 0.1);
  violations_.within(path + ".most_iterations", newton.most_iterations, 1, 1000);
  violations_.within(path + ".most_cuts", newton.most_cuts, 0, 50);
  violations_.within(path + ".growth", newton.growth, 1, 10);
  if (newton.linear_solver == LinearSolver::unspecified)
    violations_.add(path + ".linear_solver", "", "there is no such solver",
                    "choose AUTOMATIC, DIRECT or ITERATIVE");
}

void Validator::check_kind(const QuasiStatic& analysis) {
  violations_.within("analysis.quasi_static.load_steps", analysis.load_steps, 1, 1e6);
  check_newton("analysis.quasi_static.newton", analysis.newton);
  if (analysis.arc_length)
    violations_.within("analysis.quasi_static.arc_length.steps", analysis.arc_length->steps, 1, 1e6);
}

void Validator::check_kind(const ImplicitDynamics& analysis) {
  const std::string path = "analysis.implicit_dynamics";
  violations_.within(path + ".time_steps", analysis.time_steps, 1, 1e9);
  check_newton(path + ".newton", analysis.newton);
  if (const auto* newmark = std::get_if<Newmark>(&analysis.method)) {
    if (!(newmark->beta > 0 && newmark->beta <= 1))
      violations_.add(path + ".newmark.beta", number_text(newmark->beta), "out of range",
                      "give a value greater than 0 and at most 1");
    violations_.within(path + ".newmark.gamma", newmark->gamma, 0.5, 1);
  } else {
    violations_.within(path + ".generalized_alpha.spectral_radius",
                       std::get<GeneralizedAlpha>(analysis.method).spectral_radius, 0, 1);
  }
  if (analysis.mass == MassMatrix::unspecified)
    violations_.add(path + ".mass", "", "there is no such mass matrix", "choose CONSISTENT or LUMPED");
}

void Validator::check_kind(const Relaxation&) {
  violations_.add("analysis.relaxation", "", "this solver does not relax", "choose quasi_static");
}

void Validator::check_kind(const Modal&) {
  violations_.add("analysis.modal", "", "this solver knows no modes", "choose implicit_dynamics");
}

void Validator::check_kind(const Buckling&) {
  violations_.add("analysis.buckling", "", "this solver knows no buckling loads", "choose quasi_static");
}

}  // namespace trajan
