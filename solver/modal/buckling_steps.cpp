#include "solver/implicit/rigid_modes.h"
#include "solver/modal/mode_steps.h"
#include "solver/model/names.h"

namespace trajan {
namespace {

/// The tangent's derivative is a central difference over displacements of this share of a cell: of second order in
/// the strain that this is, and rounding is divided by it.
constexpr double difference_share = 1e-4;

}  // namespace

BucklingSteps::BucklingSteps(const Model& model, Executor& executor, const Checkpoint* resume)
    : ModeSteps(model, &critical_factors, executor, resume) {}

ModeProblem BucklingSteps::make_problem(const GridView& view) {
  const auto size = static_cast<Eigen::Index>(view.on.unknowns());
  const auto tangent_at = [&](const Eigen::VectorXd& displacement) {
    SparseMatrix tangent;
    if (!responses_.evaluate(view.on, span_of(displacement), model_.end_time, true).none())
      diverge("the materials have no answer to a small displacement", "check the initial state");
    view.assembly.stiffness(responses_.tangents(), tangent);
    responses_.add_stiffness(view.on, tangent);
    return tangent;
  };
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(size);
  const Constraints constraints(view.on, executor_, 0, model_.end_time);
  if (const std::string motion = find_free_motion(model_, view.on, constraints); !motion.empty())
    diverge(motion + ": nothing holds it", "hold it by a boundary condition");
  ModeProblem problem;
  problem.expand = constraints.expand();
  const SparseMatrix gather = problem.expand.transpose(), stiffness = tangent_at(rest);
  problem.stiffness = gather * stiffness * problem.expand;

  Eigen::VectorXd forces = rest;
  ExternalForces(model_, executor_).add(view.on, model_.end_time, span_of(rest), span_of(forces));
  SparseSolver solver(LinearSolver::automatic);
  solver.factorize(problem.stiffness);
  const Eigen::VectorXd answer =
      problem.expand * solver.solve(gather * (forces - stiffness * constraints.given())) + constraints.given();
  const double largest = answer.cwiseAbs().maxCoeff();
  if (!(largest > 0))
    diverge("loads and prescribed displacements are zero at analysis.end_time, " + number_text(model_.end_time) +
                ", and analysis.buckling finds factors of what they are then",
            "give loads[...] a time function that is not zero there, such as time { ramp { duration: " +
                number_text(model_.end_time) + " } }, or another analysis.end_time");
  const double share = difference_share * model_.grid.cell / largest;
  problem.other =
      gather * ((tangent_at(share * answer) - tangent_at(-share * answer)) / (2 * share)) * problem.expand;
  return problem;
}

void BucklingSteps::describe(const Eigenmode* mode, std::vector<double>& columns) const {
  columns.push_back(mode ? mode->value : 0);
  columns.push_back(mode ? mode->residual : 0);
}

}  // namespace trajan
