#include <gtest/gtest.h>

#include "solver/implicit/coarsening.h"
#include "solver/implicit/reduction.h"
#include "solver/implicit/sparse_solver.h"
#include "tests/unit/implicit/statics.h"

namespace trajan {
namespace {

using namespace test;

/// The first linear system of a scene: of its free unknowns, under its loads and prescribed motions.
struct System {
  SparseMatrix matrix;
  Eigen::VectorXd right;
  Places places;

  explicit System(const Scene& scene) {
    const Model model = validate(scene);
    Executor executor(model, 1);
    executor.begin();
    const GridView view(model, executor);
    Responses responses(model, executor);
    StepBalance balance(model, executor, view, responses, 0, 1, 1);
    const Constraints& constraints = balance.constraints();
    SparseMatrix tangent = balance.tangent();
    right = constraints.expand().transpose() * (balance.residual() - tangent * constraints.given());
    matrix = reduced(std::move(tangent), constraints.expand());
    places = constraints.places();
  }
};

/// The axes that there are.
Vector of_axes(Dimension dimension, Vector v) {
  if (grid_axes(dimension) < 3) v.z = 0;
  if (grid_axes(dimension) < 2) v.y = 0;
  return v;
}

/// A block held on its left under a shear load on its right. Its faces are not where cells end unless `offset`,
/// a share of a cell, is zero.
Scene sheared(Dimension dimension, int cells, double offset, const std::string& shapes = "linear") {
  Scene scene = block(dimension, "neo_hookean", 1, 1.0 / cells, 0.3);
  const double room = 1 + offset / cells, left = dimension == Dimension::axisymmetric ? 0 : -room;
  if (dimension == Dimension::solid || dimension == Dimension::axisymmetric) scene.domain.thickness.reset();
  const auto box = [&](Vector lower, Vector upper) {
    return Box{of_axes(dimension, lower), of_axes(dimension, upper)};
  };
  scene.domain.lower = of_axes(dimension, {left, -room, -room});
  scene.domain.upper = of_axes(dimension, {left + 3, 3 - room, 3 - room});
  scene.bodies[0].geometry = box({0, 0, 0}, {1, 1, 1});
  scene.boundaries = {{"left", box({-2, -2, -2}, {0.01 / cells, 3, 3}), Fixed{}}};
  scene.loads = {growing(traction("block", Edge::right, of_axes(dimension, {0.1, 1, 0.5})))};
  scene.numerics.shape_functions = shapes;
  return scene;
}

int cycles(const Scene& scene) {
  System system(scene);
  SparseSolver solver(LinearSolver::iterative);
  solver.factorize(system.matrix, system.places);
  const Eigen::VectorXd x = solver.solve(system.right, 1e-10);
  EXPECT_LE((system.right - system.matrix * x).norm(), 1e-8 * system.right.norm());
  return solver.iterations();
}

/// Multigrid contracts errors by a factor that does not depend on the cells (Hackbusch 1985); where bodies cut
/// cells it depends on how. A cycle of one sweep before and after leaves about a tenth.
TEST(Multigrid, NeedsAsManyCyclesWithSmallCellsAsWithLargeOnes) {
  EXPECT_LE(cycles(sheared(Dimension::plane_strain, 128, 0)), cycles(sheared(Dimension::plane_strain, 32, 0)) + 3);
  EXPECT_LE(cycles(sheared(Dimension::plane_strain, 128, 0)), 20);
  EXPECT_LE(cycles(sheared(Dimension::solid, 12, 0)), cycles(sheared(Dimension::solid, 6, 0)) + 3);
  EXPECT_LE(cycles(sheared(Dimension::solid, 12, 0.4)), cycles(sheared(Dimension::solid, 6, 0.4)) + 6);
}

struct Kind {
  const char* name;
  Scene scene;
};
std::vector<Kind> kinds() {
  Scene hinged = sheared(Dimension::plane_strain, 8, 0);
  Hinge hinge;
  hinge.surface = {"block", Edge::left, {}};
  hinge.kind = HingeKind::mean;
  hinged.boundaries = {{"hinge", {}, hinge}, {"roller", Box{{-2, -2}, {3, 0}}, Fixed{{Axis::y}}}};
  Scene pulled = sheared(Dimension::solid, 4, 0);
  pulled.boundaries.push_back({"right", Box{{1, -2, -2}, {3, 3, 3}}, PrescribedVelocity{{"0.1", "0", "0"}}});
  Scene corners = sheared(Dimension::solid, 6, 0.2, "cpdi");
  corners.numerics.scheme = "MUSL";
  return {{"Bar", sheared(Dimension::bar, 64, 0)},
          {"Axisymmetric", sheared(Dimension::axisymmetric, 12, 0.3)},
          {"Hinge", hinged},
          {"PrescribedMotion", pulled},
          {"Quadratic", sheared(Dimension::plane_strain, 16, 0, "quadratic_bspline")},
          {"Cubic", sheared(Dimension::plane_strain, 16, 0.5, "cubic_bspline")},
          {"Bernstein", sheared(Dimension::solid, 4, 0, "bernstein")},
          {"Corners", corners}};
}

/// To the tolerance times condition numbers, which are below 1e5.
TEST(Multigrid, SolvesAsFactorsDo) {
  for (const auto& [name, scene] : kinds()) {
    System system(scene);
    Eigen::VectorXd x[2];
    for (const LinearSolver choice : {LinearSolver::direct, LinearSolver::iterative}) {
      SparseSolver solver(choice);
      EXPECT_TRUE(solver.factorize(system.matrix, system.places).positive_definite) << name;
      x[choice == LinearSolver::iterative] = solver.solve(system.right, 1e-10);
      EXPECT_EQ(solver.iterations() > 0, choice == LinearSolver::iterative) << name;
    }
    EXPECT_LE((x[1] - x[0]).norm(), 1e-5 * x[0].norm()) << name;
  }
}

/// Of a matrix that is large enough for several.
TEST(Multigrid, HasTheSameBitsOnAnyNumberOfThreads) {
  System system(sheared(Dimension::solid, 11, 0.4));
  ASSERT_GE(system.matrix.nonZeros(), 300'000);
  const auto solve = [&](int threads) {
    ThreadPool pool(threads);
    SparseSolver solver(LinearSolver::iterative, &pool);
    solver.factorize(system.matrix, system.places);
    return solver.solve(system.right, 1e-10);
  };
  const Eigen::VectorXd x = solve(1);
  EXPECT_EQ(solve(2), x);
  EXPECT_EQ(solve(3), x);
}

/// Also on nodes of negative index.
TEST(Multigrid, InterpolatesWhatIsLinearExactly) {
  Places places;
  for (int k = -3; k < 4; ++k)
    for (int j = -1; j < 3; ++j)
      for (int i = 1; i < 6; ++i)
        for (const int component : {0, 1}) places.push_back({{i, j, k}, component});
  const Coarsening coarsening = coarsen(places);
  const auto linear = [](const Places& at, double cell) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(at.size()));
    for (Eigen::Index u = 0; u < values.size(); ++u) {
      const Place& place = at[static_cast<std::size_t>(u)];
      values[u] = place.component + cell * (3 * place.node[0] - place.node[1] + 0.5 * place.node[2]);
    }
    return values;
  };
  EXPECT_LT(coarsening.places.size(), places.size() / 2);
  // Small numbers and halves.
  EXPECT_EQ(coarsening.interpolation * linear(coarsening.places, 2), linear(places, 1));

  const SparseMatrix matrix = System(sheared(Dimension::solid, 3, 0.3)).matrix;
  const Interpolation some = coarsen(System(sheared(Dimension::solid, 3, 0.3)).places).interpolation;
  const SparseMatrix coarse = some.transpose() * matrix * some;
  EXPECT_LE((galerkin(matrix, some, some.transpose()) - coarse).norm(), 1e-14 * coarse.norm());
}

/// Where a matrix is not what multigrid is for factors say what it is.
TEST(Multigrid, LeavesMatricesThatAreNotDefiniteToFactors) {
  System system(sheared(Dimension::plane_strain, 8, 0));
  SparseMatrix identity(system.matrix.rows(), system.matrix.cols());
  identity.setIdentity();
  const double middle = 0.5 * system.matrix.diagonal().mean();
  const SparseMatrix indefinite = system.matrix - middle * identity;
  SparseSolver solver(LinearSolver::iterative);
  solver.factorize(indefinite, system.places);
  const Eigen::VectorXd x = solver.solve(system.right);
  EXPECT_TRUE(solver.factors().regular);
  EXPECT_FALSE(solver.factors().positive_definite);
  // Rounding times its condition.
  EXPECT_LE((indefinite * x - system.right).norm(), 1e-10 * system.right.norm());
}

}  // namespace
}  // namespace trajan
