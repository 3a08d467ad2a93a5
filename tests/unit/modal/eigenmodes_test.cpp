#include "solver/modal/eigenmodes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace trajan {
namespace {

using std::numbers::pi;

/// A chain of n unit masses and unit springs; `ends`: how many of them are tied to a wall.
SparseMatrix chain(int n, int ends) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    const bool first = i == 0 && ends < 1, last = i == n - 1 && ends < 2;
    entries.emplace_back(i, i, 2.0 - first - last);
    if (i > 0) entries.emplace_back(i, i - 1, -1.0), entries.emplace_back(i - 1, i, -1.0);
  }
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

SparseMatrix unit(int n) {
  SparseMatrix one(n, n);
  one.setIdentity();
  return one;
}

/// The same twice, side by side: every value is a pair.
SparseMatrix twice(const SparseMatrix& matrix) {
  const auto n = matrix.rows();
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < matrix.outerSize(); ++k)
    for (SparseMatrix::InnerIterator it(matrix, k); it; ++it) {
      entries.emplace_back(it.row(), it.col(), it.value());
      entries.emplace_back(it.row() + n, it.col() + n, it.value());
    }
  SparseMatrix both(2 * n, 2 * n);
  both.setFromTriplets(entries.begin(), entries.end());
  return both;
}

void expect_small_residuals(const std::vector<Eigenmode>& modes) {
  for (const Eigenmode& mode : modes) {
    std::printf("value %.15g  residual %.2g\n", mode.value, mode.residual);
    EXPECT_LE(mode.residual, 1e-8);
  }
}

// Lanczos converges to its tolerance in the inverse; the lowest value is 1e-5 of the highest.
TEST(LowestModes, OfAChainBetweenWallsAreThoseOfTheExactSolution) {
  const int n = 1000;
  const auto modes = lowest_modes(chain(n, 2), unit(n), 12);
  ASSERT_EQ(modes.size(), 12u);
  for (int k = 1; k <= 12; ++k) {
    const double exact = 4 * std::pow(std::sin(k * pi / (2 * (n + 1))), 2);
    EXPECT_NEAR(modes[static_cast<std::size_t>(k - 1)].value, exact, 1e-9 * exact) << k;
  }
  expect_small_residuals(modes);
}

TEST(LowestModes, AreOrthonormalInTheMass) {
  const int n = 300;
  const SparseMatrix mass = 3 * unit(n);
  const auto modes = lowest_modes(chain(n, 1), mass, 6);
  for (std::size_t i = 0; i < modes.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      EXPECT_NEAR(modes[i].shape.dot(mass * modes[j].shape), i == j ? 1.0 : 0.0, 1e-9) << i << " " << j;
}

TEST(LowestModes, TellRigidOnesFromTheOthers) {
  const int n = 500;
  const auto modes = lowest_modes(chain(n, 0), unit(n), 4);
  ASSERT_EQ(modes.size(), 4u);
  EXPECT_TRUE(modes[0].rigid);
  for (int k = 1; k <= 3; ++k) {
    const double exact = 4 * std::pow(std::sin(k * pi / (2 * n)), 2);
    EXPECT_FALSE(modes[static_cast<std::size_t>(k)].rigid);
    EXPECT_NEAR(modes[static_cast<std::size_t>(k)].value, exact, 1e-8 * exact) << k;
  }
}

TEST(LowestModes, MissNoneOfDegeneratePairs) {
  const int n = 400;
  const auto modes = lowest_modes(twice(chain(n, 0)), unit(2 * n), 8);
  ASSERT_EQ(modes.size(), 8u);
  for (int k = 0; k < 4; ++k) {
    const double exact = 4 * std::pow(std::sin(k * pi / (2 * n)), 2);
    for (int one : {0, 1})
      EXPECT_NEAR(modes[static_cast<std::size_t>(2 * k + one)].value, exact, 1e-8 * exact + 1e-12) << k;
  }
}

TEST(LowestModes, OfFewMassesAreAllButOne) {
  const auto modes = lowest_modes(chain(3, 2), unit(3), 10);
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_NEAR(modes[0].value, 2 - std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(modes[1].value, 2, 1e-12);
}

TEST(LowestModes, EndWhenTheyAreInterrupted) {
  struct Stop {};
  int calls = 0;
  const auto stop = [&] {
    if (++calls == 3) throw Stop{};
  };
  EXPECT_THROW(lowest_modes(chain(300, 2), unit(300), 5, stop), Stop);
}

// Rigid links and springs k = 1 at the joints of a column under the force P: the force's stiffness is -P times
// the chain's, and the k-th factor of P is the k-th value of the springs' stiffness over that.
TEST(CriticalFactors, OfAColumnOnASoftFoundationAreThoseOfTheExactSolution) {
  const int n = 400;
  const SparseMatrix links = chain(n, 2);
  const SparseMatrix stiffness = links * links + 1e-4 * unit(n), geometric = -links;
  std::vector<double> exact;
  for (int k = 1; k <= n; ++k) {
    const double value = 4 * std::pow(std::sin(k * pi / (2 * (n + 1))), 2);
    exact.push_back(value + 1e-4 / value);
  }
  std::ranges::sort(exact);
  const auto modes = critical_factors(stiffness, geometric, 5);
  ASSERT_EQ(modes.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(modes[k].value, exact[k], 1e-8 * exact[k]) << k;
  expect_small_residuals(modes);
}

TEST(CriticalFactors, DoNotExistInTension) {
  const int n = 50;
  EXPECT_TRUE(critical_factors(chain(n, 2) * chain(n, 2), chain(n, 2), 3).empty());
}

TEST(CriticalFactors, NeedAStateThatIsStable) {
  EXPECT_THROW(critical_factors(chain(50, 0), -unit(50), 1), NoModes);
}

}  // namespace
}  // namespace trajan
