#include "solver/implicit/sparse_solver.h"

#include <gtest/gtest.h>

#include "tests/unit/implicit/statics.h"

namespace trajan {
namespace {

using namespace test;

/// Second differences with what is asked for on the diagonal and above it.
SparseMatrix chain(int size, double diagonal, double above) {
  SparseMatrix matrix(size, size);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size; ++i) {
    entries.emplace_back(i, i, diagonal);
    if (i > 0) entries.emplace_back(i, i - 1, -1.0);
    if (i + 1 < size) entries.emplace_back(i, i + 1, above);
  }
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double error(const SparseMatrix& matrix, SparseSolver& solver) {
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(matrix.rows(), 1, 2);
  return (solver.solve(matrix * exact) - exact).norm() / exact.norm();
}

TEST(SparseSolver, TellsWhatAMatrixIs) {
  SparseSolver solver(LinearSolver::automatic);
  const SparseMatrix definite = chain(50, 2.1, -1), indefinite = chain(50, 0.5, -1),
                     unsymmetric = chain(50, 3, -2);
  EXPECT_TRUE(solver.factorize(definite).positive_definite);
  EXPECT_LT(error(definite, solver), 1e-13);
  for (const SparseMatrix& matrix : {indefinite, unsymmetric}) {
    const SparseSolver::Factors factors = solver.factorize(matrix);
    EXPECT_TRUE(factors.regular);
    EXPECT_FALSE(factors.positive_definite);
    EXPECT_LT(error(matrix, solver), 1e-12);
  }
  // Entries that only one triangle has.
  for (const auto& [row, column] : {std::pair{3, 40}, std::pair{40, 3}}) {
    SparseMatrix lopsided = definite;
    lopsided.coeffRef(row, column) = 0.1;
    lopsided.makeCompressed();
    EXPECT_FALSE(solver.factorize(lopsided).positive_definite);
    EXPECT_LT(error(lopsided, solver), 1e-12);
  }
  SparseMatrix singular = chain(50, 2, -1);
  singular.coeffRef(0, 0) = singular.coeffRef(49, 49) = 1;
  const SparseSolver::Factors factors = solver.factorize(singular);
  EXPECT_TRUE(!factors.regular || factors.reciprocal_condition < 1e-10);
}

TEST(SparseSolver, ConjugateGradientsFindTheSameEquilibrium) {
  double moved[2];
  for (LinearSolver choice : {LinearSolver::direct, LinearSolver::iterative}) {
    Scene scene = block(Dimension::solid, "neo_hookean", 2, 0.25, 0.3);
    scene.domain.lower = {-1, -1, -1};
    scene.domain.upper = {4, 2, 2};
    scene.domain.thickness.reset();
    scene.bodies[0].geometry = Box{{0, 0, 0}, {2, 0.5, 0.5}};
    scene.boundaries = {{"left", Box{{-1, -1, -1}, {0, 2, 2}}, Fixed{}}};
    scene.loads = {growing(traction("block", Edge::right, {0, 0.1, 0.1}))};
    scene.outputs.probes = {{"end", Vector{2, 0.5, 0.5}, {Field::displacement}, ""}};
    QuasiStatic analysis{2};
    analysis.newton.linear_solver = choice;
    scene.analysis.kind = analysis;
    const Model model = validate(scene);
    const Answer answer = solve(model);
    ASSERT_EQ(answer.result.end, RunEnd::finished);
    moved[choice == LinearSolver::direct ? 0 : 1] = answer.memory.rows.back()[column(model, "end.displacement.y")];
  }
  EXPECT_GT(moved[0], 0.01);
  // Newton's tolerance is 1e-8 of the forces, which a slender body multiplies by its condition.
  EXPECT_NEAR(moved[1], moved[0], 1e-5 * moved[0]);
}

}  // namespace
}  // namespace trajan
