#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "solver/implicit/step_balance.h"
#include "tests/unit/implicit/statics.h"

/// A body whose outermost particles reach only so far into the next cells, along both axes.
namespace trajan {
namespace {

using namespace test;

struct Conditions2 {
  double with = 0, without = 0;
};

double condition(const GridView& view, const GhostPenalty& ghost, ThreadPool& pool, const Responses& responses,
                 const SparseMatrix& expand) {
  const Assembly assembly(view.on, ghost, pool);
  SparseMatrix stiffness;
  assembly.stiffness(responses.tangents(), stiffness);
  const Eigen::MatrixXd reduced = Eigen::MatrixXd(SparseMatrix(expand.transpose()) * stiffness * expand);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(reduced, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[reduced.rows() - 1] / solver.eigenvalues()[0];
}

Conditions2 conditions(const char* shapes, double reach) {
  const double cell = 0.25;
  Scene scene = block(Dimension::plane_strain, "neo_hookean", 2, cell, 0.3);
  // Particles are a quarter of a cell from the body's face; B-splines end between nodes.
  const double face = cell * (std::string(shapes) == "quadratic_bspline" ? 0.75 : 0.25);
  scene.bodies[0].geometry =
      Box{{face + reach * cell - 0.5, face + reach * cell}, {2 + face + reach * cell, 1 + face + reach * cell}};
  scene.boundaries = {{"left", Box{{-1, -1}, {0, 3}}, Fixed{}}};
  scene.numerics.shape_functions = shapes;
  const Model model = validate(scene);
  Executor executor(model, 1);
  executor.begin();
  const GridView view(model, executor);
  Responses responses(model, executor);
  const StepBalance balance(model, executor, view, responses, 0, 1, 1);
  const SparseMatrix& expand = balance.constraints().expand();
  return {condition(view, view.ghost, executor.pool(), responses, expand),
          condition(view, {}, executor.pool(), responses, expand)};
}

TEST(GhostPenalty, KeepsConditionNumbersWhereverTheBoundaryCutsCells) {
  for (const char* shapes : {"linear", "gimp", "quadratic_bspline", "cubic_bspline", "bernstein"}) {
    const double half_way = conditions(shapes, 0.5).with;
    for (double reach : {1e-2, 1e-3, 1e-4}) {
      const auto [with, without] = conditions(shapes, reach);
      RecordProperty(std::string(shapes) + "_" + std::to_string(reach),
                     std::to_string(with) + " instead of " + std::to_string(without));
      EXPECT_LT(with, 2 * half_way) << shapes << ' ' << reach;
      EXPECT_GT(with, 0) << shapes << ' ' << reach;
    }
  }
}

TEST(GhostPenalty, WithoutItConditionNumbersGrowWithoutBound) {
  // Weights fall with the reach, stiffness with its square: 1e4 from 1e-2 to 1e-4.
  EXPECT_GT(conditions("linear", 1e-4).without, 1e3 * conditions("linear", 1e-2).without);
}

TEST(GhostPenalty, HoldsNothingOfABodyWhoseFacesLieOnTheGrid) {
  for (const char* shapes : {"linear", "gimp", "quadratic_bspline", "cubic_bspline", "bernstein"}) {
    Scene scene = block(Dimension::plane_strain, "neo_hookean", 2, 0.25, 0.3);
    scene.numerics.shape_functions = shapes;
    const Model model = validate(scene);
    Executor executor(model, 1);
    executor.begin();
    EXPECT_TRUE(GhostPenalty(model, Discretization(model, executor)).differences().empty()) << shapes;
  }
}

}  // namespace
}  // namespace trajan
