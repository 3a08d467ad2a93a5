#include "solver/implicit/dynamic_steps.h"

#include "solver/implicit/reduction.h"
#include "solver/simulation/checkpoint_array.h"

namespace trajan {
namespace {

std::string name_of(std::size_t body) { return "body" + std::to_string(body) + ".acceleration"; }

Eigen::VectorXd to_eigen(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

DynamicSteps::Weights::Weights(const ImplicitDynamics& analysis) {
  if (const auto* newmark = std::get_if<Newmark>(&analysis.method)) {
    beta = newmark->beta;
    gamma = newmark->gamma;
    return;
  }
  // Equations 17 and 25 of Chung and Hulbert.
  const double rho = std::get<GeneralizedAlpha>(analysis.method).spectral_radius;
  alpha_m = (2 * rho - 1) / (rho + 1);
  alpha_f = rho / (rho + 1);
  gamma = 0.5 - alpha_m + alpha_f;
  beta = 0.25 * (1 - alpha_m + alpha_f) * (1 - alpha_m + alpha_f);
}

DynamicSteps::DynamicSteps(const Model& model, const ImplicitDynamics& analysis, Executor& executor,
                           const Checkpoint* resume)
    : ImplicitSteps(model, executor, analysis.newton, analysis.time_steps, resume),
      model_(model),
      lumped_(analysis.mass == MassMatrix::lumped),
      weights_(analysis) {
  if (!resume) return;
  if (total_lagrangian()) {
    velocity_ = to_eigen(checkpoint_array<double>(*resume, "node_velocity"));
    acceleration_ = to_eigen(checkpoint_array<double>(*resume, "node_acceleration"));
    return;
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    accelerations_.push_back(checkpoint_array<double>(*resume, name_of(b)));
}

void DynamicSteps::save(Checkpoint& checkpoint) const {
  ImplicitSteps::save(checkpoint);
  if (total_lagrangian()) {
    checkpoint.arrays.push_back({"node_velocity", std::vector<double>(velocity_.begin(), velocity_.end())});
    checkpoint.arrays.push_back(
        {"node_acceleration", std::vector<double>(acceleration_.begin(), acceleration_.end())});
    return;
  }
  for (std::size_t b = 0; b < accelerations_.size(); ++b)
    checkpoint.arrays.push_back({name_of(b), accelerations_[b]});
}

void DynamicSteps::begin_step(StepBalance& balance) {
  const bool first = velocity_.size() == 0 && accelerations_.empty();
  if (mass_.rows() == 0 || !total_lagrangian()) view().assembly.mass(lumped_, mass_);
  if (first)
    begin_motion(balance);
  else if (!total_lagrangian())
    map_from_particles();
  const auto [alpha_m, alpha_f, beta, gamma] = weights_;
  const double dt = balance.duration(), damping = model_.damping;
  // Acceleration and velocity at the end: the displacement times a factor, and these.
  const Eigen::VectorXd a = -velocity_ / (beta * dt) - (0.5 / beta - 1) * acceleration_;
  const Eigen::VectorXd v = velocity_ + dt * ((1 - gamma) * acceleration_ + gamma * a);
  Inertia inertia;
  inertia.mass = &mass_;
  inertia.forces_share = 1 - alpha_f;
  inertia.of_displacement = (1 - alpha_m) / (beta * dt * dt) + damping * (1 - alpha_f) * gamma / (beta * dt);
  inertia.constant =
      alpha_f * (balance.external_before() - balance.internal_before()) -
      mass_ * ((1 - alpha_m) * a + alpha_m * acceleration_ + damping * ((1 - alpha_f) * v + alpha_f * velocity_));
  balance.set_inertia(std::move(inertia));
}

void DynamicSteps::end_step(const StepBalance& balance, const Eigen::VectorXd& displacement) {
  const auto [alpha_m, alpha_f, beta, gamma] = weights_;
  const double dt = balance.duration(), damping = model_.damping;
  const Eigen::VectorXd acceleration =
      (displacement - dt * velocity_) / (beta * dt * dt) - (0.5 / beta - 1) * acceleration_;
  const Eigen::VectorXd velocity = velocity_ + dt * ((1 - gamma) * acceleration_ + gamma * acceleration);
  const Eigen::VectorXd before = mass_ * velocity_, after = mass_ * velocity;
  const Eigen::VectorXd inertia_before = mass_ * acceleration_ + damping * before,
                        inertia = mass_ * acceleration + damping * after;
  executor().account().add(balance.work(displacement, inertia_before, inertia),
                           0.5 * damping * (before + after).dot(displacement));
  // With the weights that accelerations have in the change of velocities, and so of momentum.
  const Eigen::VectorXd held_before = balance.internal_before() - balance.external_before() + inertia_before,
                        held = balance.internal() - balance.external() + inertia;
  balance.constraints().add_reactions((1 - gamma) * held_before + gamma * held, dt,
                                      executor().account().reactions());
  const Eigen::VectorXd change = velocity - velocity_;
  velocity_ = velocity;
  acceleration_ = acceleration;
  map_to_particles(change);
}

/// The velocity whose momentum is that of the particles and the acceleration that balances the forces, both as the
/// boundary conditions allow.
void DynamicSteps::begin_motion(const StepBalance& balance) {
  const auto size = static_cast<Eigen::Index>(view().on.unknowns());
  Eigen::VectorXd momentum = Eigen::VectorXd::Zero(size);
  const int axes = view().on.axes();
  const auto blocks = executor().tiles().blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const BodyParticles& body = executor().bodies()[blocks[b].body];
    for (std::uint32_t i = 0; i < blocks[b].count; ++i) {
      const std::size_t p = view().on.first_particle(b) + i;
      const Discretization::Particle particle = view().on.particle(p);
      for (std::size_t k = 0; k < particle.nodes.size(); ++k)
        for (int axis = 0; axis < axes; ++axis)
          momentum[static_cast<Eigen::Index>(particle.nodes[k]) * axes + axis] +=
              view().on.mass(p) * particle.weights[k] *
              body.component(Attribute::velocity_x, axis)[blocks[b].begin + i];
    }
  }
  const SparseMatrix& expand = balance.constraints().expand();
  SparseSolver solver(LinearSolver::direct);
  solver.factorize(reduced(SparseMatrix(mass_), expand));
  velocity_ = expand * solver.solve(expand.transpose() * momentum);
  const Eigen::VectorXd missing =
      balance.external_before() - balance.internal_before() - model_.damping * (mass_ * velocity_);
  acceleration_ = expand * solver.solve(expand.transpose() * missing);
  if (total_lagrangian()) return;
  for (const Body& body : model_.bodies)
    accelerations_.emplace_back(static_cast<std::size_t>(body.particles * axes), 0.0);
}

void DynamicSteps::map_from_particles() {
  const auto size = static_cast<Eigen::Index>(view().on.unknowns());
  const int axes = view().on.axes();
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(size);
  velocity_ = acceleration_ = mass;
  const auto blocks = executor().tiles().blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const BodyParticles& body = executor().bodies()[blocks[b].body];
    const std::vector<double>& accelerations = accelerations_[blocks[b].body];
    for (std::uint32_t i = 0; i < blocks[b].count; ++i) {
      const std::size_t p = view().on.first_particle(b) + i, slot = blocks[b].begin + i;
      const Discretization::Particle particle = view().on.particle(p);
      for (std::size_t k = 0; k < particle.nodes.size(); ++k)
        for (int axis = 0; axis < axes; ++axis) {
          const Eigen::Index u = static_cast<Eigen::Index>(particle.nodes[k]) * axes + axis;
          const double share = view().on.mass(p) * particle.weights[k];
          mass[u] += share;
          velocity_[u] += share * body.component(Attribute::velocity_x, axis)[slot];
          acceleration_[u] +=
              share *
              accelerations[body.number[slot] * static_cast<std::size_t>(axes) + static_cast<std::size_t>(axis)];
        }
    }
  }
  for (Eigen::Index u = 0; u < size; ++u) {
    velocity_[u] = mass[u] > 0 ? velocity_[u] / mass[u] : 0;
    acceleration_[u] = mass[u] > 0 ? acceleration_[u] / mass[u] : 0;
  }
}

void DynamicSteps::map_to_particles(const Eigen::VectorXd& velocity_change) {
  const int axes = view().on.axes();
  executor().visit([&](Block& block, std::size_t b, std::size_t) {
    const BlockRange& range = executor().tiles().blocks()[b];
    for (int i = 0; i < block.count; ++i) {
      const Discretization::Particle particle =
          view().on.particle(view().on.first_particle(b) + static_cast<std::size_t>(i));
      const std::size_t number =
          executor().bodies()[range.body].number[range.begin + static_cast<std::uint32_t>(i)];
      for (int axis = 0; axis < axes; ++axis) {
        double change = 0, acceleration = 0;
        for (std::size_t k = 0; k < particle.nodes.size(); ++k) {
          const Eigen::Index u = static_cast<Eigen::Index>(particle.nodes[k]) * axes + axis;
          change += particle.weights[k] * velocity_change[u];
          acceleration += particle.weights[k] * acceleration_[u];
        }
        block.component(Attribute::velocity_x, axis)[i] += change;
        if (!total_lagrangian())
          accelerations_[range.body][number * static_cast<std::size_t>(axes) + static_cast<std::size_t>(axis)] =
              acceleration;
      }
    }
  });
}

}  // namespace trajan
