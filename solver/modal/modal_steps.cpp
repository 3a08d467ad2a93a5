#include <cmath>
#include <numbers>
#include <utility>

#include "solver/implicit/reduction.h"
#include "solver/modal/mode_steps.h"

namespace trajan {
namespace {

/// Whether loads, motions or an initial stress leave the initial state before the body vibrates.
bool leaves_initial_state(const Model& model, Executor& executor) {
  const auto has_state = [](const Body& body) {
    const auto given = [](const auto& formula) { return formula.has_value(); };
    return std::ranges::any_of(body.stress, given) || std::ranges::any_of(body.deformation, given);
  };
  return !model.surface_loads.empty() || !model.body_loads.empty() ||
         std::ranges::any_of(model.bodies, has_state) ||
         !Constraints(Discretization(model, executor), executor, 0, model.end_time).homogeneous();
}

}  // namespace

ModalSteps::ModalSteps(const Model& model, const Modal& analysis, Executor& executor, const Checkpoint* resume)
    : ModeSteps(model, &lowest_modes, executor, resume), lumped_(analysis.mass == MassMatrix::lumped) {
  if (!resume && leaves_initial_state(model, executor)) preload_.emplace(model, preloading_, executor, nullptr);
}

bool ModalSteps::prepare(std::int64_t number) {
  if (preload_ && !preload_->advance(model_.end_time, number)) return false;
  preload_.reset();
  return true;
}

ModeProblem ModalSteps::make_problem(const GridView& view) {
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(view.on.unknowns()));
  const Constraints constraints(view.on, executor_, model_.end_time, model_.end_time);
  responses_.evaluate(view.on, {rest.data(), view.on.unknowns()}, model_.end_time, true);
  ModeProblem problem;
  SparseMatrix stiffness, mass;
  view.assembly.stiffness(responses_.tangents(), stiffness);
  responses_.add_stiffness(view.on, stiffness);
  view.assembly.mass(lumped_, mass);
  problem.expand = constraints.expand();
  problem.stiffness = reduced(std::move(stiffness), problem.expand);

  const Eigen::Index axes = view.on.axes(), nodes = static_cast<Eigen::Index>(view.on.nodes());
  SparseMatrix translations(axes * nodes, axes);
  for (Eigen::Index axis = 0; axis < axes; ++axis)
    for (Eigen::Index n = 0; n < nodes; ++n) translations.insert(n * axes + axis, axis) = 1;
  momenta_ = SparseMatrix(problem.expand.transpose()) * (mass * translations).eval();
  problem.other = reduced(std::move(mass), problem.expand);
  for (std::size_t p = 0; p < view.on.particles(); ++p) total_mass_ += view.on.mass(p);
  return problem;
}

/// Frequency and residual, and the share of the whole mass that moves with the mode along each axis.
void ModalSteps::describe(const Eigenmode* mode, std::vector<double>& columns) const {
  const double square = mode && !mode->rigid ? mode->value : 0;
  columns.push_back(std::sqrt(square) / (2 * std::numbers::pi));
  columns.push_back(mode ? mode->residual : 0);
  for (int axis = 0; axis < grid_axes(model_.dimension); ++axis) {
    const double momentum = mode ? momenta_.col(axis).dot(mode->shape) : 0;
    columns.push_back(mode ? momentum * momentum / total_mass_ : 0);
  }
}

}  // namespace trajan
