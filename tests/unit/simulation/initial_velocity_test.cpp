#include <gtest/gtest.h>

#include <cmath>

#include "solver/simulation/simulation.h"
#include "tests/epsilon.h"
#include "tests/unit/simulation/scenes.h"

/// What the first step makes of a velocity that is linear in the place, v = L x, without stress.
namespace trajan::initial_velocity_test {
namespace {

using test::epsilon;
constexpr double rate[2][2] = {{0.1, 0.2}, {-0.3, 0.05}};
constexpr double small = 1e-6, cell = 0.5;

/// A block from (0, 0) to (5, 5) with free edges on nodes, two particles along a cell's side.
struct FirstStep {
  FirstStep(const std::string& scheme, const std::string& shape, const std::string& transfer,
            std::optional<int> order)
      : model(make(scheme, shape, transfer, order)), simulation(model, 1) {
    // The first one's particles have deformed once the second one has begun.
    simulation.step();
    simulation.step();
  }
  static Model make(const std::string& scheme, const std::string& shape, const std::string& transfer,
                    std::optional<int> order) {
    Scene scene;
    scene.name = "block";
    scene.domain = {Dimension::plane_strain, {-2, -2}, {7, 7}, cell, 1};
    scene.materials = {test::material("neo_hookean", 1e-12, 0.3, 1)};
    const auto component = [](int row) {
      return std::to_string(small * rate[row][0] * 1e6) + "e-6*x+" + std::to_string(small * rate[row][1] * 1e6) +
             "e-6*y";
    };
    scene.bodies = {{"block", "solid", Box{{0, 0}, {5, 5}}, 2, {component(0), component(1)}}};
    scene.analysis = {4, 0};
    scene.numerics.time_step = 1;
    scene.numerics.scheme = scheme;
    scene.numerics.shape_functions = shape;
    scene.numerics.transfer = transfer;
    scene.numerics.transfer_order = order;
    scene.outputs.samples = 1;
    return validate(scene);
  }
  const BodyParticles& particles() const { return simulation.executor().bodies()[0]; }
  /// The largest error of the deformation, by the largest component of L, of particles at least so many cells away
  /// from the edges.
  double error(double away) const {
    double largest = 0;
    for (std::size_t i = 0; i < particles().size(); ++i) {
      const double x = particles()[Attribute::position_x][i], y = particles()[Attribute::position_y][i];
      if (std::min(std::min(x, 5 - x), std::min(y, 5 - y)) < away * cell) continue;
      for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column) {
          const double f = particles().component(Attribute::deformation_xx, 3 * row + column)[i] - (row == column);
          largest = std::max(largest, std::abs(f / small - rate[row][column]));
        }
    }
    return largest / 0.3;
  }
  Model model;
  Simulation simulation;
};

/// F - 1 is L t but for (L t)^2, and is rounded like 1.
constexpr double exact = 10 * (small + epsilon / small);

TEST(LinearVelocity, IsExactByAffineTransfersUpToFreeEdges) {
  for (const char* shape : {"gimp", "quadratic_bspline", "cubic_bspline"})
    EXPECT_LT(FirstStep("MUSL", shape, "APIC", {}).error(0), exact) << shape;
}

// Momentum and lumped masses give a node the velocity at the centre of what its particles weigh, L x_c. That is
// the node itself inside of the body alone: no transfer that keeps momentum and knows a particle by its velocity
// only can do better with lumped masses. At a free edge on a node linear functions have x_c 3/8 of a cell inside.
TEST(LinearVelocity, IsThatOfCentresOfMassByFlip) {
  for (const char* shape : {"linear", "gimp", "quadratic_bspline", "cubic_bspline"}) {
    const FirstStep step("MUSL", shape, "FLIP", {});
    EXPECT_LT(step.error(4), exact) << shape;
    EXPECT_GT(step.error(0), 0.1) << shape;
  }
  EXPECT_NEAR(FirstStep("MUSL", "linear", "FLIP", {}).error(0), 3.0 / 8, 1e-3);
}

// The terms are (1 - S+ S)^j, which takes what the grid cannot tell from the exact velocity, 3/8 at first, to
// zero: by a factor of at most 3/4, as S+ S has no eigenvalue below 1/4 along a line with two particles in a cell.
// Where a scheme maps velocities a second time, these have lumped masses alone.
TEST(LinearVelocity, IsApproachedByMoreTermsOfTheFullMassMatrix) {
  double bound = 3.0 / 8;
  for (int order = 1; order <= 16; ++order, bound *= 0.75)
    EXPECT_LT(FirstStep("USL", "linear", "FMPM", order).error(0), bound + exact) << order;
}

}  // namespace
}  // namespace trajan::initial_velocity_test
