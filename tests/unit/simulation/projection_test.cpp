#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "solver/simulation/simulation.h"
#include "tests/epsilon.h"
#include "tests/unit/simulation/scenes.h"

/// XPIC and FMPM against what they approximate.
namespace trajan::projection_test {
namespace {

using test::epsilon;

/// A free block of 4 x 1 about the origin, without stress.
Scene block(const std::string& transfer, int order, double cell) {
  Scene scene;
  scene.name = "block";
  scene.domain = {Dimension::plane_strain, {-4, -2}, {4, 2}, cell, 1};
  scene.materials = {test::material("neo_hookean", 1, 0.3, 1)};
  scene.bodies = {{"block", "solid", Box{{-2, -0.5}, {2, 0.5}}, 2, {}}};
  scene.analysis = {10, 0};
  scene.numerics.scheme = "USL";
  scene.numerics.transfer = transfer;
  if (transfer != "FLIP") scene.numerics.transfer_order = order;
  scene.outputs.samples = 1;
  return scene;
}

/// Runs two steps: the first one's particles have their velocities once the second one has begun.
struct AfterTheFirstStep {
  explicit AfterTheFirstStep(const Scene& scene) : model(validate(scene)), simulation(model, 1) {
    simulation.step();
    simulation.step();
  }
  const BodyParticles& particles() const { return simulation.executor().bodies()[0]; }
  Model model;
  Simulation simulation;
};

double energy(const BodyParticles& particles) {
  double sum = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
    sum += std::pow(particles[Attribute::velocity_x][i], 2) + std::pow(particles[Attribute::velocity_y][i], 2);
  return sum;
}

/// Share of a smooth motion's energy that one step takes.
double loss(int order, double cell) {
  Scene scene = block("XPIC", order, cell);
  // As good as nothing at the ends.
  scene.bodies[0].initial_velocity = {"0", "exp(-6*x^2)"};
  const Model model = validate(scene);
  const double before = energy(Simulation(model, 1).executor().bodies()[0]);
  return 1 - energy(AfterTheFirstStep(scene).particles()) / before;
}

TEST(Xpic, TakesFromASmoothMotionAnEnergyOfTwiceItsOrder) {
  for (int order : {1, 2, 3}) {
    const double coarse = loss(order, 1.0 / 8), fine = loss(order, 1.0 / 16);
    EXPECT_GT(fine, 0) << order;
    EXPECT_NEAR(std::log2(coarse / fine), 2 * order, 0.3) << order << ": " << coarse << " " << fine;
  }
}

/// Largest deviation of velocities from their mean, in the middle of a block whose rows of particles move to
/// and fro by turns.
double ringing(const std::string& transfer, int order) {
  Scene scene = block(transfer, order, 0.25);
  scene.bodies[0].initial_velocity = {"1+0.1*cos(pi*((x+2)/0.125-0.5))", "0"};
  const AfterTheFirstStep after(scene);
  double largest = 0;
  for (std::size_t i = 0; i < after.particles().size(); ++i)
    if (std::abs(after.particles()[Attribute::position_x][i]) < 0.5)
      largest = std::max(largest, std::abs(after.particles()[Attribute::velocity_x][i] - 1));
  return largest;
}

TEST(Xpic, RemovesVelocitiesThatTheGridCannotSee) {
  EXPECT_NEAR(ringing("FLIP", 1), 0.1, 1e-6);
  for (int order : {1, 2, 4}) EXPECT_LT(ringing("XPIC", order), 16 * epsilon) << order;
}

using Field = std::map<std::pair<int, int>, double>;

/// Bilinear functions, by themselves.
template <class Of>
void for_each_weight(const Model& model, const BodyParticles& particles, std::size_t i, Of&& of) {
  const double x = (particles[Attribute::position_x][i] - model.grid.origin.x) / model.grid.cell;
  const double y = (particles[Attribute::position_y][i] - model.grid.origin.y) / model.grid.cell;
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  for (int k = 0; k < 4; ++k) {
    const double fx = x - column, fy = y - row;
    of(std::pair(column + k % 2, row + k / 2), (k % 2 ? fx : 1 - fx) * (k / 2 ? fy : 1 - fy));
  }
}

std::vector<double> at_particles(const Model& model, const BodyParticles& particles, const Field& nodes) {
  std::vector<double> values(particles.size(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i)
    for_each_weight(model, particles, i, [&](auto node, double w) {
      if (nodes.contains(node)) values[i] += w * nodes.at(node);
    });
  return values;
}

Field at_nodes(const Model& model, const BodyParticles& particles, const std::vector<double>& values) {
  Field sums;
  for (std::size_t i = 0; i < values.size(); ++i)
    for_each_weight(model, particles, i, [&](auto node, double w) { sums[node] += w * values[i]; });
  return sums;
}

double dot(const Field& a, const Field& b) {
  double sum = 0;
  for (const auto& [node, value] : a) sum += value * b.at(node);
  return sum;
}

/// What the consistent mass matrix makes of the particles' velocities, at the particles: by conjugate gradients.
std::vector<double> consistent(const Model& model, const BodyParticles& particles) {
  Field residual = at_nodes(model, particles, particles[Attribute::velocity_x]);
  Field direction = residual, velocity;
  double square = dot(residual, residual);
  const double enough = 1e-26 * square;
  while (square > enough) {
    const Field product = at_nodes(model, particles, at_particles(model, particles, direction));
    const double step = square / dot(direction, product), last = square;
    for (auto& [node, r] : residual) {
      velocity[node] += step * direction[node];
      r -= step * product.at(node);
    }
    square = dot(residual, residual);
    for (auto& [node, d] : direction) d = residual[node] + square / last * d;
  }
  return at_particles(model, particles, velocity);
}

TEST(Fmpm, ApproachesTheConsistentMassMatrix) {
  Scene scene = block("FMPM", 1, 0.25);
  scene.bodies[0].initial_velocity = {"sin(2*x)+y*x", "0"};
  const Model model = validate(scene);
  const std::vector<double> exact = consistent(model, Simulation(model, 1).executor().bodies()[0]);
  double last = 1;
  for (int order : {1, 2, 4, 8, 16}) {
    scene.numerics.transfer_order = order;
    const AfterTheFirstStep after(scene);
    double error = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
      error += std::pow(after.particles()[Attribute::velocity_x][i] - exact[i], 2);
    error = std::sqrt(error / static_cast<double>(exact.size()));
    RecordProperty("order_" + std::to_string(order), std::to_string(error));
    EXPECT_LT(error, last) << order;
    last = error;
  }
}

TEST(Projections, LeavePrescribedNodesAlone) {
  for (const char* transfer : {"XPIC", "FMPM"}) {
    Scene scene = test::bar("MUSL", "neo_hookean", 0.5, 0.1);
    scene.numerics.transfer = transfer;
    scene.numerics.transfer_order = 5;
    const Model model = validate(scene);
    Simulation simulation(model, 1);
    for (int step = 0; step < 3; ++step) simulation.step();
    const Tiles& tiles = simulation.executor().tiles();
    const NodeVector taken = transfer == std::string("XPIC") ? node_projected_velocity : node_velocity;
    int found = 0;
    for (std::size_t tile = 0; tile < tiles.tiles().size(); ++tile)
      for (int node = 0; node < tile_nodes; ++node) {
        const double x = model.grid.origin.x + model.grid.cell * (tiles.tiles()[tile].at[0] * 8 + node % 8);
        const double mass = tiles.nodes(tile)[node];
        if (std::abs(x) > 1e-9 || mass == 0) continue;
        ++found;
        EXPECT_EQ(tiles.nodes(tile)[tile_array(quantity(taken, 0, 2)) + node], 0) << transfer;
      }
    EXPECT_EQ(found, 3) << transfer;
  }
}

}  // namespace
}  // namespace trajan::projection_test
