#include "solver/relaxation/dynamic_relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "solver/implicit/rigid_modes.h"
#include "solver/model/names.h"
#include "solver/schemes/scheme.h"
#include "solver/schemes/schemes.h"
#include "solver/schemes/time_step.h"
#include "solver/simulation/diverged.h"
#include "solver/simulation/fastest_particle.h"

namespace trajan {
namespace {

/// Wave speeds change as bodies deform: the time step is found again after so many steps.
constexpr std::int64_t steps_per_time_step = 64;

/// A level is stuck if for so many maxima of the kinetic energy, or so many times the time that it is given to
/// come to one, and for so many times the steps that it took to the least residual, that has not become less by
/// this share. Levels that converge improve by more with each maximum or two.
constexpr std::int64_t most_vain_peaks = 100, most_vain_times = 3, most_vain_waits = 4;
constexpr double least_improvement = 0.5;

/// A body that vibrates comes to a maximum of its kinetic energy within a quarter of its longest period, which is
/// about a quarter as many crossings of its waves as the body is slender. One that moves for so many without any
/// is driven away.
constexpr double most_crossings = 64;

/// Slows the waves of all bodies down to the slowest one's, and returns how fast that is.
double equalise_waves(const Model& model, Executor& executor) {
  const auto speed = [&](const Body& body) {
    const Material& material = model.materials[body.material];
    return material.kind->wave_speed(material.parameters, material.density, model.dimension);
  };
  double slowest = std::numeric_limits<double>::infinity();
  for (const Body& body : model.bodies) slowest = std::min(slowest, speed(body));
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const double ratio = speed(model.bodies[b]) / slowest;
    if (ratio > 1) executor.scale_inertia(b, ratio * ratio);
  }
  return slowest;
}

double longest_side(const Model& model) {
  double longest = 0;
  for (const Body& body : model.bodies) {
    const Lattice& lattice = body.lattice;
    longest = std::max({longest, static_cast<double>(lattice.columns) * lattice.spacing.x,
                        static_cast<double>(lattice.rows) * lattice.spacing.y,
                        static_cast<double>(lattice.planes) * lattice.spacing.z});
  }
  return longest;
}

/// Whether something may hold a body that is not a displacement which is prescribed.
bool may_be_stopped(const Model& model) {
  const auto prescribes = [](const BoundaryCondition& condition) {
    return std::holds_alternative<PrescribedMotion>(condition.kind) ||
           std::holds_alternative<HeldSurface>(condition.kind);
  };
  return model.contacts.fields > 1 || !std::ranges::all_of(model.conditions, prescribes);
}

/// What nothing holds as all lies now, and how it can move.
std::string find_free_motion_now(const Model& model, Executor& executor, double time) {
  if (may_be_stopped(model)) return "";
  if (model.numerics.precision == float_precision) {
    // Equations need doubles. What is held does not depend on how far bodies have moved.
    Model in_doubles = model;
    in_doubles.numerics.precision = "DOUBLE";
    Executor at_first(in_doubles, 1);
    at_first.begin();
    return find_free_motion_now(in_doubles, at_first, time);
  }
  const Discretization on(model, executor);
  return find_free_motion(model, on, Constraints(on, executor, time, time));
}

/// The node of the largest unbalanced force, after a kick: where it is in cells, and its velocity field.
struct LeastBalanced {
  std::array<double, 3> place{};
  std::uint32_t field = 0;

  LeastBalanced(const Tiles& tiles, int axes) {
    const int side = tiles.layout().side;
    double largest = -1;
    for (std::size_t t = 0; t < tiles.tiles().size(); ++t)
      for (int node = 0; node < tile_nodes; ++node) {
        const double* values = tiles.nodes(t) + node;
        double square = 0;
        for (int axis = 0; axis < axes; ++axis) {
          const double a = values[tile_array(quantity(node_acceleration, axis, axes))];
          square += std::pow(values[tile_array(quantity_mass)] * a, 2);
        }
        if (!(square > largest)) continue;
        largest = square;
        const Tile& tile = tiles.tiles()[t];
        field = tile.field;
        const int within[] = {node % side, node / side % side, node / (side * side)};
        for (std::size_t axis = 0; axis < 3; ++axis) place[axis] = side * tile.at[axis] + within[axis];
      }
  }
};

/// The particle that is nearest to the largest unbalanced force.
Slot least_balanced_particle(const Model& model, const Executor& executor) {
  const int axes = grid_axes(model.dimension);
  const LeastBalanced node(executor.tiles(), axes);
  const double origin[] = {model.grid.origin.x, model.grid.origin.y, model.grid.origin.z};
  Slot nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t b = 0; b < executor.bodies().size(); ++b) {
    if (model.contacts.fields > 1 && model.contacts.field_of[b] != node.field) continue;
    const BodyParticles& body = executor.bodies()[b];
    for (std::uint32_t i = 0; i < body.size(); ++i) {
      double square = 0;
      for (int axis = 0; axis < axes; ++axis) {
        const double x = body.component(Attribute::position_x, axis)[i] - origin[axis];
        square += std::pow(x - model.grid.cell * node.place[static_cast<std::size_t>(axis)], 2);
      }
      if (square < least) least = square, nearest = {b, i};
    }
  }
  return nearest;
}

/// Whether velocities for gradients are those that particles bring back to the nodes. From rest to rest these take
/// nodes as far as the nodes' own velocities take particles, since what a kick adds to one and not yet to the
/// other sums up to the change of velocity, which FLIP hands on whole. Particles that are halted have not been
/// slowed down by kicks, and are too far by a time step.
bool outruns_strains(const Numerics& numerics) {
  return numerics.scheme != "USL" && numerics.transfer == "FLIP" && numerics.flip_fraction.value_or(1) == 1 &&
         numerics.precision != float_precision;
}

std::string remedy_of_stuck(const Model& model) {
  const std::string larger = "accept a larger analysis.relaxation.tolerance, or ";
  if (model.numerics.shape_functions != "linear" && model.numerics.shape_functions != "bernstein")
    return larger +
           "take one more of bodies.particles_per_cell_side: nodes that particles of a surface hardly reach "
           "come to rest last, and linear functions have none";
  if (has_contact(model))
    return larger +
           "load slowly in explicit dynamics with analysis.damping: nodes at which bodies meet touch and "
           "part again while all else is nearly at rest";
  if (is_total_lagrangian(model.numerics.scheme)) return larger + "choose analysis.quasi_static";
  return larger + "choose numerics.scheme: \"TLMPM\", by which no particles cross cells and make noise";
}

}  // namespace

DynamicRelaxation::DynamicRelaxation(const Model& model, const Relaxation& limits, Executor& executor,
                                     const Checkpoint* resume)
    : model_(model), scheme_(*find_scheme(model.numerics.scheme)), limits_(limits), executor_(executor) {
  if (resume) from_ = until_ = resume->time;
  executor_.account().watch_forces(executor_.tiles().tiles().size());
  crossing_time_ = longest_side(model) / equalise_waves(model, executor_);
  free_motion_ = find_free_motion_now(model, executor_, until_);
}

std::vector<Warning> DynamicRelaxation::warnings() const {
  if (free_motion_.empty()) return {};
  Warning warning;
  warning.name = "free motion";
  warning.particle = model_.bodies[0].first_particle;
  warning.place = model_.bodies[0].lattice.point_of(0);
  warning.cause =
      free_motion_ + ": nothing holds it, and where it comes to rest, if it does, is not given by the loads alone";
  warning.remedy = "hold it by a boundary condition";
  return {warning};
}

double DynamicRelaxation::time() const {
  return std::lerp(from_, until_, std::clamp(std::log(least_) / std::log(limits_.tolerance), 0.0, 1.0));
}

std::int64_t DynamicRelaxation::steps_left() const {
  const double levels = static_cast<double>(model_.outputs.samples) * (1 - until_ / model_.end_time);
  const std::int64_t of_each = std::max(steps_of_level_, steps_of_last_level_);
  return static_cast<std::int64_t>(levels + 0.5) * of_each + of_each - steps_of_level_;
}

void DynamicRelaxation::record(std::vector<double>& columns) const {
  columns.insert(columns.end(), {residual_, static_cast<double>(steps_of_last_level_)});
}

/// At a sample everything is at rest: there is nothing to remember.
void DynamicRelaxation::save(Checkpoint&) const {}

void DynamicRelaxation::begin_level() {
  at_rest_ = true;
  first_unbalanced_ = 0;
  steps_of_level_ = least_at_ = peaks_since_ = last_peak_ = 0;
  least_ = smallest_ = 1;
}

bool DynamicRelaxation::advance(double until, std::int64_t number) {
  if (until != until_) begin_level();
  until_ = until;
  number_ = number;
  if (steps_of_level_ % steps_per_time_step == 0) find_time_step();
  bool halted = false;
  try {
    step();
    measure();
    halted = residual_ <= limits_.tolerance;
    if (halted && is_settled()) {
      from_ = until_;
      steps_of_last_level_ = steps_of_level_;
      return true;
    }
  } catch (const Diverged& diverged) {
    Divergence divergence = diverged.divergence();
    divergence.remedy = "apply less load, or " + divergence.remedy;
    give_up(divergence);
  }
  if (!halted) {
    // Not by the kinetic energy of the nodes: what a kick gives them falls with the forces, and of smooth
    // functions most of it is lost on the particles.
    halted = executor_.account().balance().power < 0;
    at_rest_ = false;
    if (halted) halt();
  }
  watch_progress(halted);
  return false;
}

/// Says which load is borne, and what is loose if anything is.
void DynamicRelaxation::give_up(Divergence divergence) const {
  std::string beyond =
      "beyond the load factor " + std::to_string(from_ / model_.end_time) + " no state of rest is found: ";
  if (!free_motion_.empty()) {
    beyond = free_motion_ + ": nothing holds it, and " + beyond;
    divergence.remedy = "hold it by a boundary condition, or choose a dynamic analysis";
  }
  divergence.cause = beyond + divergence.cause;
  throw Diverged(divergence);
}

void DynamicRelaxation::find_time_step() {
  const Totals totals = executor_.totals();
  time_step_ = model_.numerics.time_step ? *model_.numerics.time_step
                                         : model_.numerics.time_step_fraction *
                                               stable_time_step(model_, std::sqrt(totals.squared_wave_speed),
                                                                std::sqrt(totals.squared_speed));
}

void DynamicRelaxation::step() {
  StepTimes times;
  times.step = number_;
  times.time = until_;
  times.before = at_rest_ ? until_ : until_ - 0.5 * time_step_;
  times.after = until_ + 0.5 * time_step_;
  times.drift = time_step_;
  scheme_.step(executor_, times);
  ++steps_of_level_;
}

void DynamicRelaxation::measure() {
  const ForceBalance& balance = executor_.account().balance();
  const double unbalanced = std::sqrt(balance.unbalanced), external = std::sqrt(balance.external);
  if (first_unbalanced_ == 0) first_unbalanced_ = unbalanced;
  const double scale = external > 0 ? external : first_unbalanced_;
  residual_ = scale > 0 ? unbalanced / scale : 0;
}

/// Velocities first catch up with the places of the particles: without the half kick the energies of two times
/// would be compared, and work of half a step at the greatest speed be missing.
void DynamicRelaxation::halt() {
  StepTimes times;
  times.step = number_;
  times.time = times.after = until_;
  times.before = until_ - 0.5 * time_step_;
  synchronise(executor_, times);
  executor_.halt(outruns_strains(model_.numerics) ? time_step_ : 0);
  at_rest_ = true;
}

/// The forces were those of the places before the step: looks again where the particles are now, at rest.
bool DynamicRelaxation::is_settled() {
  halt();
  const Exchanged exchanged = executor_.account().exchanged();
  executor_.account().forget_reactions();
  StepTimes times;
  times.step = number_;
  times.time = times.before = until_;
  times.after = until_ + 0.5 * time_step_;
  executor_.particles({Pass::locate, Pass::force, Pass::scatter_state});
  executor_.update_velocities(times);
  executor_.account().restore(exchanged);
  // The force at the sample is recorded as if it had been there since the last one.
  const double interval = model_.end_time / static_cast<double>(model_.outputs.samples);
  for (Reaction& reaction : executor_.account().reactions())
    for (double& impulse : reaction.impulse) impulse *= interval / (times.after - times.before);
  measure();
  return residual_ <= limits_.tolerance;
}

void DynamicRelaxation::watch_progress(bool peak) {
  peaks_since_ += peak;
  if (peak) last_peak_ = steps_of_level_;
  if (static_cast<double>(steps_of_level_ - last_peak_) * time_step_ > most_crossings * crossing_time_) {
    last_peak_ = steps_of_level_;  // a body that is held is given as much time again
    if (!free_motion_.empty())
      give_up({number_, until_, -1,
               "what moves has not come to rest after " + std::to_string(steps_of_level_) + " steps", ""});
  }
  smallest_ = std::min(smallest_, residual_);
  if (residual_ < (1 - least_improvement) * least_) {
    least_ = residual_;
    least_at_ = steps_of_level_;
    peaks_since_ = 0;
  }
  const double vain_time = static_cast<double>(steps_of_level_ - least_at_) * time_step_;
  const bool vain =
      peaks_since_ > most_vain_peaks || vain_time > most_vain_waits * most_crossings * crossing_time_;
  const bool stuck = vain && steps_of_level_ > (1 + most_vain_times) * least_at_;
  if (!stuck && steps_of_level_ < limits_.most_steps) return;
  const Slot worst = least_balanced_particle(model_, executor_);
  std::ostringstream cause;
  cause << (stuck ? "the relaxation is stuck" : "the relaxation has not come to rest") << " after "
        << steps_of_level_ << " steps of a load level: unbalanced forces are " << residual_
        << " of the external ones, at best " << smallest_ << " (" << limits_.tolerance
        << " is asked for), most in body " << quoted(model_.bodies[worst.body].name);
  give_up({number_, until_, particle_number(model_, executor_, worst), cause.str(),
           stuck ? remedy_of_stuck(model_) : "allow more analysis.relaxation.most_steps"});
}

}  // namespace trajan
