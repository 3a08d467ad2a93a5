#include "solver/implicit/implicit_steps.h"

#include <algorithm>
#include <cmath>

#include "solver/implicit/motion.h"
#include "solver/implicit/reduction.h"
#include "solver/implicit/rigid_modes.h"
#include "solver/implicit/weak_place.h"
#include "solver/model/names.h"
#include "solver/schemes/scheme.h"
#include "solver/simulation/checkpoint_array.h"
#include "solver/simulation/diverged.h"
#include "solver/simulation/fastest_particle.h"

namespace trajan {
namespace {

/// Equations this badly conditioned make one ask whether all bodies are held.
constexpr double suspicious_condition = 1e-10;
constexpr const char* state_name = "step";
/// Of the whole time: what load a body bears is not asked for more precisely.
constexpr double least_share = 1e-7;
constexpr double asymmetry = 1e-9;

/// Whether the tangent of a step has a direction without resistance, though it is symmetric. Paths by arc length
/// may lead there; under given loads a body does not stay there.
bool is_unstable(const Model& model, const NewtonIterations& newton, StepBalance& balance) {
  const auto* statics = std::get_if<QuasiStatic>(&model.analysis);
  if (!statics || statics->arc_length || newton.factors().positive_definite) return false;
  const SparseMatrix tangent = reduced(balance.tangent(), balance.constraints().expand());
  return (tangent - SparseMatrix(tangent.transpose())).norm() <= asymmetry * tangent.norm();
}

}  // namespace

ImplicitSteps::ImplicitSteps(const Model& model, Executor& executor, const Newton& newton, int steps,
                             const Checkpoint* resume)
    : model_(model),
      executor_(executor),
      options_(newton),
      longest_(model.end_time / steps),
      shortest_(std::min(least_share * model.end_time, std::ldexp(longest_, -newton.most_cuts))),
      total_lagrangian_(is_total_lagrangian(model.numerics.scheme)),
      responses_(model, executor),
      solver_(newton.linear_solver, &executor.pool()),
      length_(longest_) {
  if (!resume) return;
  time_ = resume->time;
  const auto& state = checkpoint_array<double>(*resume, state_name);
  length_ = state[0];
  steps_ = static_cast<std::int64_t>(state[1]);
  iterations_ = static_cast<std::int64_t>(state[2]);
  out_of_reach_ = state[3];
}

void ImplicitSteps::save(Checkpoint& checkpoint) const {
  checkpoint.arrays.push_back({state_name, std::vector<double>{length_, static_cast<double>(steps_),
                                                               static_cast<double>(iterations_), out_of_reach_}});
}

std::int64_t ImplicitSteps::steps_left() const {
  const double steps = std::ceil((model_.end_time - time_) / length_ - 1e-9);
  const double each = steps_ > 0 ? static_cast<double>(iterations_) / static_cast<double>(steps_) : 4;
  return static_cast<std::int64_t>(std::ceil(steps * each));
}

bool ImplicitSteps::advance(double until, std::int64_t number) {
  number_ = number;
  try {
    if (!newton_) begin(until);
    const NewtonIterations::State state = newton_->iterate();
    refuse_free_motion();
    if (state == NewtonIterations::State::failed) cut();
    if (state == NewtonIterations::State::converged) accept();
  } catch (const FormulaNotFinite& error) {
    diverge(error.what(), "give a formula that is finite throughout the run");
  }
  return time_ == until;
}

/// Steps between two samples are of the same length, at most that which is asked for.
void ImplicitSteps::begin(double until) {
  if (sample_ != until) executor_.account().forget_reactions();
  sample_ = until;
  if (!view_) view_ = std::make_unique<GridView>(model_, executor_);
  const double left = until - time_, steps = std::ceil(left / length_ - 1e-9);
  next_ = steps <= 1 ? until : time_ + left / steps;
  balance_ = make_balance(time_, next_);
  begin_step(*balance_);
  newton_ = make_iterations(*balance_);
}

std::unique_ptr<StepBalance> ImplicitSteps::balance_between(double from, double to, double duration) {
  return std::make_unique<StepBalance>(model_, executor_, *view_, responses_, from, to, duration);
}

std::unique_ptr<StepBalance> ImplicitSteps::make_balance(double from, double to) {
  return balance_between(from, to, to - from);
}

std::unique_ptr<NewtonIterations> ImplicitSteps::make_iterations(StepBalance& balance) {
  return std::make_unique<NewtonIterations>(options_, solver_, balance);
}

void ImplicitSteps::end_step(const StepBalance& balance, const Eigen::VectorXd& displacement) {
  executor_.account().add(balance.work(displacement), 0);
  // The force at the sample is recorded as if it had been there since the last one.
  executor_.account().forget_reactions();
  balance.constraints().add_reactions(balance.internal() - balance.external(),
                                      model_.end_time / static_cast<double>(model_.outputs.samples),
                                      executor_.account().reactions());
}

void ImplicitSteps::accept() {
  if (is_unstable(model_, *newton_, *balance_))
    diverge("the equilibrium at the load factor " + std::to_string(next_ / model_.end_time) + " is not stable: " +
                largest_place(model_, view_->on, newton_->weakest()) + " gives way to the least disturbance",
            "apply less load, find the critical one by analysis.buckling, or trace the path by "
            "analysis.quasi_static.arc_length");
  const Eigen::VectorXd& displacement = newton_->displacement();
  end_step(*balance_, displacement);
  move_by(displacement, time_, next_, view_->on, model_, executor_);
  responses_.commit(view_->on, span_of(displacement), balance_->duration());
  time_ = next_;
  ++steps_;
  iterations_ += newton_->iterations();
  residuals_ = newton_->residuals();
  cuts_ = 0;
  const double grown = std::min(length_ * options_.growth, longest_);
  // Not past where there was no way to: what a step half as long did not reach, a longer one will not.
  const bool into_the_unknown = time_ < out_of_reach_ && time_ + grown > out_of_reach_;
  if (2 * newton_->iterations() <= options_.most_iterations && !into_the_unknown) length_ = grown;
  newton_.reset();
  balance_.reset();
  if (total_lagrangian_) return;
  const std::int64_t outside = outside_domain(model_, executor_);
  if (outside >= 0)
    throw Diverged(
        {number_, time_, outside, particle_text(model_, outside) + " left the domain",
         "enlarge domain.lower and domain.upper (empty space costs nothing), or hold the body by a boundary"});
  executor_.sort();
  view_.reset();
}

/// Towards a load that cannot be borne steps that converge become ever shorter, so that their length says that
/// there is no way on, and not only how often one has been cut.
void ImplicitSteps::cut() {
  length_ = 0.5 * balance_->duration();
  if (cuts_ == options_.most_cuts || length_ < shortest_ ||
      newton_->failure() == NewtonIterations::Failure::no_load)
    give_up();
  ++cuts_;
  out_of_reach_ = next_;
  newton_.reset();
  balance_.reset();
}

void ImplicitSteps::refuse_free_motion() const {
  if (!needs_supports()) return;
  const SparseSolver::Factors& factors = newton_->factors();
  if (newton_->failure() == NewtonIterations::Failure::no_answer && newton_->iterations() == 0) return;
  if (factors.regular && factors.reciprocal_condition > suspicious_condition) return;
  const std::string motion = find_free_motion(model_, view_->on, balance_->constraints());
  if (!motion.empty())
    diverge(motion + ": nothing holds it, and it has no equilibrium, or many",
            "hold it by a boundary condition, or choose a dynamic analysis");
}

std::string ImplicitSteps::where() const { return "the load factor " + std::to_string(time_ / model_.end_time); }

void ImplicitSteps::give_up() const {
  using Failure = NewtonIterations::Failure;
  if (newton_->failure() == Failure::no_load)
    diverge("the loads do not change with time at " + where() + ": no path leads on from there",
            "let loads grow until analysis.end_time, for example by time { ramp { duration: " +
                std::to_string(model_.end_time) + " } }");
  const std::string beyond = "no equilibrium is found beyond " + where() + ": ";
  if (newton_->failure() == Failure::no_answer) {
    const std::int64_t body = balance_->trouble().body;
    diverge(
        beyond + "however short the step, particles " +
            (body < 0 ? "" : "of body " + quoted(model_.bodies[static_cast<std::size_t>(body)].name) + " ") +
            "lose their positive volume",
        "apply less load, trace the path by analysis.quasi_static.arc_length, or take a finer grid or a material "
        "that bears such a deformation");
  }
  if (newton_->failure() == Failure::unsolved)
    diverge(
        beyond +
            "iterations do not solve the linear equations, whose factors would be too large; the stiffness of " +
            largest_place(model_, view_->on, newton_->weakest()) + " is least",
        "take larger cells, stiffnesses that are less apart, a Poisson's ratio farther from 0.5, or "
        "newton.linear_solver: DIRECT");
  if (newton_->failure() == Failure::singular || !newton_->factors().positive_definite)
    diverge(beyond + "the stiffness of " + largest_place(model_, view_->on, newton_->weakest()) +
                " is lost: the body bears no more, or may go more than one way from here",
            "apply less load, or trace the path by analysis.quasi_static.arc_length");
  give_up_on_balance(beyond);
}

void ImplicitSteps::give_up_on_balance(const std::string& beyond) const {
  const std::string most = "most of it in " + largest_place(model_, view_->on, newton_->missing());
  const double left = newton_->residuals().back(), rounding = newton_->rounding(model_.grid.cell);
  if (left <= rounding)
    diverge(beyond + "rounding alone leaves " + number_text(left) + " of the forces unbalanced, " + most +
                ", which is too stiff for such loads",
            "accept newton.tolerance: " + number_text(rounding) + ", or give stiffnesses that are less apart");
  diverge(
      beyond + "Newton's method leaves " + number_text(left) + " of the forces unbalanced, " + most,
      "allow more newton.most_iterations or shorter steps; a path is traced by analysis.quasi_static.arc_length");
}

void ImplicitSteps::diverge(const std::string& cause, const std::string& remedy) const {
  throw Diverged({number_, time_, -1, cause, remedy});
}

}  // namespace trajan
