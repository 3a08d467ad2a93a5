#include <algorithm>

#include "solver/model/names.h"
#include "solver/model/validator.h"

namespace trajan {

namespace {

/// Its parts, of which there can be as many as samples and steps, are still normal numbers.
constexpr double shortest_time = 1e-280;

/// The field of a condition that prescribes a motion; nullptr: it prescribes none.
const char* prescribed_motion(const decltype(BoundaryDefinition::condition)& condition) {
  if (std::holds_alternative<PrescribedVelocity>(condition)) return "prescribed_velocity";
  if (std::holds_alternative<PrescribedDisplacement>(condition)) return "prescribed_displacement";
  const auto* hinge = std::get_if<Hinge>(&condition);
  return hinge && (hinge->displacement.x || hinge->displacement.y || hinge->displacement.z) ? "hinge" : nullptr;
}

}  // namespace

void Validator::check_analysis() {
  const double end_time = scene_.analysis.end_time;
  clock_complete_ = violations_.positive("analysis.end_time", end_time);
  if (clock_complete_ && end_time < shortest_time) {
    clock_complete_ =
        violations_.add("analysis.end_time", number_text(end_time), "too short to be divided into steps",
                        "give at least " + number_text(shortest_time) + ", or choose other units");
  }
  violations_.not_negative("analysis.damping", scene_.analysis.damping);
  model_.end_time = end_time;
  model_.damping = scene_.analysis.damping;
  model_.analysis = scene_.analysis.kind;
  std::visit([this](const auto& kind) { check_kind(kind); }, scene_.analysis.kind);
}

/// What means nothing to analyses that solve for displacements must not be asked for.
void Validator::check_implicit_choices() {
  const Numerics& numerics = scene_.numerics;
  const auto refuse = [this](const std::string& path, const std::string& value, const std::string& remedy) {
    violations_.add(path, value, "it is for explicit time steps, and this analysis has none", remedy);
  };
  if (numerics.scheme != Numerics{}.scheme && numerics.scheme != "TLMPM")
    refuse("numerics.scheme", numerics.scheme, "leave it out (updated Lagrangian), or choose \"TLMPM\" (total)");
  if (numerics.transfer != Numerics{}.transfer) refuse("numerics.transfer", numerics.transfer, "leave it out");
  if (numerics.time_step) refuse("numerics.time_step", number_text(*numerics.time_step), "leave it out");
  if (numerics.time_step_fraction != Numerics{}.time_step_fraction)
    refuse("numerics.time_step_fraction", number_text(numerics.time_step_fraction), "leave it out");
  if (!scene_.contacts.empty())
    violations_.add("contacts", "", "contact is for explicit time steps",
                    "leave them out, or choose explicit_dynamics");
  for (std::size_t i = 0; i < scene_.boundaries.size(); ++i) {
    const auto& condition = scene_.boundaries[i].condition;
    const std::string path = indexed("boundaries", i) + ".";
    const char* rigid = std::holds_alternative<RigidPlane>(condition)  ? "rigid_plane"
                        : std::holds_alternative<RigidBall>(condition) ? "rigid_ball"
                                                                       : nullptr;
    if (rigid)
      violations_.add(path + rigid, "", "contact is for explicit time steps",
                      "hold nodes or surfaces, or choose explicit_dynamics");
    if (std::holds_alternative<Absorbing>(condition))
      violations_.add(path + "absorbing", "", "dashpots are for explicit time steps",
                      "leave it out, or choose explicit_dynamics");
    if (std::holds_alternative<Periodic>(condition))
      violations_.add(path + "periodic", "", "analyses that solve for displacements know no periodic axes",
                      "hold the body's ends, or choose explicit_dynamics");
  }
}

void Validator::check_statics() {
  check_implicit_choices();
  if (scene_.analysis.damping != 0)
    violations_.add("analysis.damping", number_text(scene_.analysis.damping),
                    "an equilibrium has no velocity to damp", "leave it out, or choose a dynamic analysis");
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
    const VectorExpression& velocity = scene_.bodies[i].initial_velocity;
    if (velocity.x || velocity.y || velocity.z)
      violations_.add(indexed("bodies", i) + ".initial_velocity", "", "an equilibrium has no velocity",
                      "leave it out, or choose a dynamic analysis");
  }
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

void Validator::check_mass(const std::string& path, MassMatrix mass) {
  if (mass == MassMatrix::unspecified)
    violations_.add(path + ".mass", "", "there is no such mass matrix", "choose CONSISTENT or LUMPED");
}

void Validator::check_kind(const QuasiStatic& analysis) {
  violations_.within("analysis.quasi_static.load_steps", analysis.load_steps, 1, 1e6);
  check_newton("analysis.quasi_static.newton", analysis.newton);
  check_statics();
  if (!analysis.arc_length) return;
  const std::string path = "analysis.quasi_static.arc_length";
  violations_.within(path + ".steps", analysis.arc_length->steps, 1, 1e6);
  if (scene_.numerics.scheme != "TLMPM")
    violations_.add("numerics.scheme", scene_.numerics.scheme,
                    "a path is followed by the unknowns of one grid, which the updated configuration renews",
                    "choose \"TLMPM\"");
  for (std::size_t i = 0; i < scene_.boundaries.size(); ++i) {
    const char* moves = prescribed_motion(scene_.boundaries[i].condition);
    if (moves)
      violations_.add(indexed("boundaries", i) + "." + moves, "",
                      "a path is traced under loads, with what is held at rest",
                      "apply loads, or take steps of given motion without arc_length");
  }
}

void Validator::check_kind(const ImplicitDynamics& analysis) {
  const std::string path = "analysis.implicit_dynamics";
  violations_.within(path + ".time_steps", analysis.time_steps, 1, 1e9);
  check_newton(path + ".newton", analysis.newton);
  check_implicit_choices();
  if (const auto* newmark = std::get_if<Newmark>(&analysis.method)) {
    if (!(newmark->beta > 0 && newmark->beta <= 1))
      violations_.add(path + ".newmark.beta", number_text(newmark->beta), "out of range",
                      "give a value greater than 0 and at most 1");
    violations_.within(path + ".newmark.gamma", newmark->gamma, 0.5, 1);
  } else {
    violations_.within(path + ".generalized_alpha.spectral_radius",
                       std::get<GeneralizedAlpha>(analysis.method).spectral_radius, 0, 1);
  }
  check_mass(path, analysis.mass);
}

/// Samples are modes.
void Validator::check_modes() {
  constexpr std::int32_t most = 1000;
  check_statics();
  if (scene_.outputs.samples > most)
    violations_.add("outputs.samples", std::to_string(scene_.outputs.samples), "every sample is a mode",
                    "ask for at most 1000");
  if (!scene_.outputs.reactions.empty())
    violations_.add("outputs.reactions", "", "modes have no forces, as they have no size",
                    "leave it out, or choose quasi_static");
  for (std::size_t i = 0; i < scene_.loads.size(); ++i) {
    const auto* pressure = std::get_if<Pressure>(&scene_.loads[i].kind);
    if (pressure && pressure->follows)
      violations_.add(
          indexed("loads", i) + ".pressure.configuration", "",
          "a pressure that follows the surface makes the stiffness unsymmetric, which modes must not be of",
          "choose REFERENCE");
  }
}

void Validator::check_kind(const Modal& analysis) {
  check_modes();
  check_mass("analysis.modal", analysis.mass);
}

void Validator::check_kind(const Buckling&) {
  check_modes();
  const auto moves = [](const BoundaryDefinition& boundary) {
    return prescribed_motion(boundary.condition) != nullptr;
  };
  if (scene_.loads.empty() && std::ranges::none_of(scene_.boundaries, moves))
    violations_.add("loads", "",
                    "analysis.buckling finds the factors of loads at which bodies buckle, and there are none",
                    "give a load or a prescribed displacement that is not zero at analysis.end_time");
}

}  // namespace trajan
