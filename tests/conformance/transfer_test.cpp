#include "solver/transfers/transfer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "solver/schemes/scheme.h"
#include "solver/schemes/schemes.h"
#include "solver/simulation/simulation.h"
#include "tests/epsilon.h"
#include "tests/unit/simulation/scenes.h"

/// What every transfer must do with every kind of shape functions. Both come from their registries.
namespace trajan::transfer_test {
namespace {

using test::epsilon;

struct TransferCase {
  std::string transfer, shape, scheme;
  Dimension dimension;
};
std::string name_of(const TransferCase& of) {
  return of.transfer + "_" + of.shape + "_" + of.scheme + "_" + std::to_string(grid_axes(of.dimension)) + "D";
}
std::ostream& operator<<(std::ostream& out, const TransferCase& of) { return out << name_of(of); }

/// What varies in all directions, affinely.
VectorExpression affine_motion(Dimension dimension) {
  switch (grid_axes(dimension)) {
    case 1:
      return {"0.3+x", {}, {}};
    case 2:
      return {"0.3-2*y+x", "2*x-0.2", {}};
    default:
      return {"0.3-2*y+x", "2*x-0.2+z", "0.1-y"};
  }
}
VectorExpression uniform_motion(Dimension dimension) {
  VectorExpression velocity{"0.3", {}, {}};
  if (grid_axes(dimension) > 1) velocity.y = "-0.2";
  if (grid_axes(dimension) > 2) velocity.z = "0.1";
  return velocity;
}

Vector along_axes(Dimension dimension, double x, double y, double z) {
  const int axes = grid_axes(dimension);
  return {x, axes > 1 ? y : 0, axes > 2 ? z : 0};
}

/// A free block of 2 x 1 x 0.5 about the origin, as far as there are axes.
Scene block(const TransferCase& of) {
  Scene scene;
  scene.name = "block";
  scene.domain.dimension = of.dimension;
  scene.domain.lower = along_axes(of.dimension, -10, -10, -10);
  scene.domain.upper = along_axes(of.dimension, 10, 10, 10);
  scene.domain.cell_size = 0.25;
  scene.materials = {test::material("neo_hookean", 100, 0.3, 1)};
  scene.bodies = {{"block", "solid", {}, 2, {}}};
  scene.bodies[0].geometry =
      Box{along_axes(of.dimension, -1, -0.5, -0.25), along_axes(of.dimension, 1, 0.5, 0.25)};
  scene.analysis = {1, 0};
  scene.numerics.scheme = of.scheme;
  scene.numerics.shape_functions = of.shape;
  scene.numerics.transfer = of.transfer;
  scene.outputs.samples = 5;
  return scene;
}

bool is_refused(const Scene& scene) {
  try {
    validate(scene);
    return false;
  } catch (const std::exception&) {
    return true;
  }
}

std::vector<TransferCase> all_transfers() {
  std::vector<TransferCase> cases;
  for (std::string_view transfer : transfer_names())
    for (std::string_view shape : shape_names())
      for (std::string_view scheme : scheme_names())
        for (Dimension dimension : {Dimension::bar, Dimension::plane_strain, Dimension::solid}) {
          const TransferCase made{std::string(transfer), std::string(shape), std::string(scheme), dimension};
          if (!is_refused(block(made))) cases.push_back(made);
        }
  return cases;
}

class Transfers : public testing::TestWithParam<TransferCase> {};
INSTANTIATE_TEST_SUITE_P(Registry, Transfers, testing::ValuesIn(all_transfers()),
                         [](const auto& named) { return name_of(named.param); });

const BodyParticles& particles(const Simulation& simulation) { return simulation.executor().bodies()[0]; }

/// About the origin in the plane of two axes: of the particles' places, and of how velocities vary about them.
double angular_momentum(const Simulation& simulation, int a, int b) {
  const BodyParticles& p = particles(simulation);
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    sum += p.component(Attribute::position_x, a)[i] * p.component(Attribute::velocity_x, b)[i] -
           p.component(Attribute::position_x, b)[i] * p.component(Attribute::velocity_x, a)[i] +
           p.component(Attribute::affine_xx, 3 * b + a)[i] - p.component(Attribute::affine_xx, 3 * a + b)[i];
  return p.constants.mass * sum;
}

TEST_P(Transfers, KeepMassAndMomentum) {
  Scene scene = block(GetParam());
  // Spinning and stretched, so that there are forces.
  scene.bodies[0].initial_velocity = affine_motion(GetParam().dimension);
  const Model model = validate(scene);
  Simulation simulation(model, 1);
  const std::vector<double> first = simulation.columns();
  while (simulation.sample() < model.outputs.samples) simulation.step();
  // In each step every particle's momentum is rounded in all exchanges, in the worst case all of them one way:
  // the sum of their magnitudes is below 2 times 3.
  const double tolerance = 8 * epsilon * 6 * static_cast<double>(simulation.steps());
  for (int axis = 0; axis < grid_axes(GetParam().dimension); ++axis) {
    const std::size_t c = test::column(model, std::string("momentum.") + "xyz"[axis]);
    EXPECT_NEAR(simulation.columns()[c], first[c], tolerance) << axis;
  }
  double mass = 0;
  const Tiles& tiles = simulation.executor().tiles();
  for (std::size_t tile = 0; tile < tiles.tiles().size(); ++tile)
    for (int node = 0; node < tile_nodes; ++node) mass += tiles.nodes(tile)[tile_array(quantity_mass) + node];
  const BodyParticles& p = particles(simulation);
  // Sums of some hundred terms.
  EXPECT_NEAR(mass, p.constants.mass * static_cast<double>(p.size()), 400 * epsilon);
}

TEST_P(Transfers, KeepAngularMomentumIfTheyAreAffine) {
  if (!find_transfer(GetParam().transfer)->affine || find_scheme(GetParam().scheme)->total_lagrangian) return;
  Scene scene = block(GetParam());
  scene.bodies[0].initial_velocity = affine_motion(GetParam().dimension);
  const Model model = validate(scene);
  Simulation simulation(model, 1);
  const int axes = grid_axes(GetParam().dimension);
  double first[3][3] = {};
  for (int a = 0; a < axes; ++a)
    for (int b = 0; b < a; ++b) first[a][b] = angular_momentum(simulation, a, b);
  while (simulation.sample() < model.outputs.samples) {
    if (!simulation.step()) continue;
    // As above, with arms below 2.
    const double tolerance = 8 * epsilon * 12 * static_cast<double>(simulation.steps());
    for (int a = 0; a < axes; ++a)
      for (int b = 0; b < a; ++b) EXPECT_NEAR(angular_momentum(simulation, a, b), first[a][b], tolerance);
  }
}

TEST_P(Transfers, ReproduceUniformMotionAndAffineOnesIfTheyAreAffine) {
  Scene scene = block(GetParam());
  scene.bodies[0].initial_velocity = uniform_motion(GetParam().dimension);
  if (find_transfer(GetParam().transfer)->affine)
    scene.bodies[0].initial_velocity = affine_motion(GetParam().dimension);
  // Ten steps without forces that are so short that particles stay where they are.
  scene.materials = {test::material("neo_hookean", 1e-20, 0.3, 1)};
  scene.analysis.end_time = 1e-14;
  scene.numerics.time_step = 1e-15;
  const Model model = validate(scene);
  Simulation simulation(model, 1);
  const std::vector<double> before = particles(simulation)[Attribute::velocity_x];
  while (simulation.sample() < model.outputs.samples) simulation.step();
  const std::vector<double>& after = particles(simulation)[Attribute::velocity_x];
  // Particles are still in the order in which they were sorted at first. In every step a velocity of up to 3 is
  // the quotient of sums of at most 64 terms, there and back.
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 10 * 64 * 3 * epsilon) << i;
}

/// Velocities and how they vary, by the particles' numbers, component by component.
std::vector<std::vector<double>> velocities(const Simulation& simulation, int axes) {
  const BodyParticles& p = particles(simulation);
  std::vector<std::vector<double>> by_number(p.size());
  for (std::size_t slot = 0; slot < p.size(); ++slot)
    for (int a = 0; a < axes; ++a) {
      by_number[p.number[slot]].push_back(p.component(Attribute::velocity_x, a)[slot]);
      for (int b = 0; b < axes; ++b)
        by_number[p.number[slot]].push_back(p.component(Attribute::affine_xx, 3 * a + b)[slot]);
    }
  return by_number;
}

TEST_P(Transfers, DoTheSameNearFacesIfTheyAreAffine) {
  if (!find_transfer(GetParam().transfer)->affine) return;
  const Dimension dimension = GetParam().dimension;
  const int axes = grid_axes(dimension);
  Scene scene = block(GetParam());
  scene.bodies[0].initial_velocity = affine_motion(dimension);
  scene.analysis.end_time = 0.05;  // less than a third of a cell
  const auto at_the_end = [&] {
    const Model model = validate(scene);
    Simulation simulation(model, 1);
    while (simulation.sample() < model.outputs.samples) simulation.step();
    return velocities(simulation, axes);
  };
  const auto away = at_the_end();
  // Two cells from the faces no function is another one, but blocks are thought to reach them. Elements of two
  // cells begin where they did.
  scene.domain.lower = along_axes(dimension, -1.5, -1, -1);
  scene.domain.upper = along_axes(dimension, 1.5, 1, 1);
  const auto near = at_the_end();
  ASSERT_EQ(near.size(), away.size());
  // Some ten steps, in each of which a velocity of up to 5 is the quotient of sums of at most 64 terms, there and
  // back, and levers of up to 2 cells multiply by up to 4 what rounding has made.
  const double tolerance = 10 * 64 * 5 * 2 * 4 * epsilon;
  for (std::size_t i = 0; i < near.size(); ++i)
    for (std::size_t c = 0; c < near[i].size(); ++c)
      EXPECT_NEAR(near[i][c], away[i][c], tolerance) << i << ' ' << c;
}

/// D of the functions for which it is the same everywhere, over the square of the cell.
double inertia(const std::string& shape) {
  return shape == "quadratic_bspline" ? 1.0 / 4 : shape == "cubic_bspline" ? 1.0 / 3 : 0.0;
}

double kinetic_energy(const Simulation& simulation, int axes, double affine_inertia) {
  const BodyParticles& p = particles(simulation);
  double sum = 0;
  for (int a = 0; a < axes; ++a) {
    for (double v : p.component(Attribute::velocity_x, a)) sum += v * v;
    for (int b = 0; b < axes; ++b)
      for (double moment : p.component(Attribute::affine_xx, 3 * a + b)) sum += moment * moment / affine_inertia;
  }
  return 0.5 * p.constants.mass * sum;
}

TEST_P(Transfers, GainNoEnergyInFreeFlight) {
  const bool affine = find_transfer(GetParam().transfer)->affine;
  // What varies about a particle has energy that depends on its place by other functions.
  if (affine && inertia(GetParam().shape) == 0) return;
  Scene scene = block(GetParam());
  // As good as no stiffness, so that there are no forces and the particles fly apart.
  scene.materials = {test::material("neo_hookean", 1e-20, 0.3, 1)};
  scene.bodies[0].initial_velocity = affine_motion(GetParam().dimension);
  scene.bodies[0].initial_velocity.x->append("+sin(7*x)");
  scene.analysis.end_time = 0.3;
  const Model model = validate(scene);
  Simulation simulation(model, 1);
  const double cell = model.grid.cell, affine_inertia = inertia(GetParam().shape) * cell * cell;
  const int axes = grid_axes(GetParam().dimension);
  double energy = kinetic_energy(simulation, axes, affine_inertia);
  const double first = energy;
  while (simulation.sample() < model.outputs.samples) {
    if (!simulation.step()) continue;
    const double now = kinetic_energy(simulation, axes, affine_inertia);
    // Roundings of all particles, one way.
    EXPECT_LE(now, energy + 64 * epsilon * first);
    energy = now;
  }
  if (GetParam().transfer == "FLIP") {
    EXPECT_NEAR(energy, first, 64 * epsilon * first);
  }
}

}  // namespace
}  // namespace trajan::transfer_test
