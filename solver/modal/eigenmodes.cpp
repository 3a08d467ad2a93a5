#include "solver/modal/eigenmodes.h"

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>
#include <Spectra/SymGEigsSolver.h>

#include <Eigen/CholmodSupport>
#include <algorithm>
#include <cmath>
#include <typeinfo>

#include "solver/implicit/sparse_solver.h"

namespace trajan {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The shift, as a share of the highest values.
constexpr double shift_share = 1e-11;
/// What counts as zero, likewise: rounding leaves some 1e-14 of rigid motions, and the lowest bending mode of a
/// beam has 5e-12 with a length of 300 heights, each of four cells.
constexpr double zero_share = 5e-13;
constexpr double tolerance = 1e-11;
constexpr int most_restarts = 300;

/// Middle one of the ratios of diagonal entries: about the highest values, whatever nodes hardly touch the body.
double value_scale(const SparseMatrix& stiffness, const SparseMatrix& mass) {
  VectorXd ratio = stiffness.diagonal().cwiseQuotient(mass.diagonal());
  std::nth_element(ratio.begin(), ratio.begin() + ratio.size() / 2, ratio.end());
  return ratio[ratio.size() / 2];
}

/// L D L^T without pivoting, of which D has the signs of the matrix's values.
class SignedFactors : public Eigen::CholmodSimplicialLDLT<SparseMatrix, Eigen::Lower> {
 public:
  explicit SignedFactors(const SparseMatrix& matrix) {
    cholmod().print = 0;
    compute(matrix);
  }
  Index negative_pivots() const {
    const auto* columns = static_cast<const int*>(m_cholmodFactor->p);
    const auto* entries = static_cast<const double*>(m_cholmodFactor->x);
    Index negative = 0;
    for (std::size_t i = 0; i < m_cholmodFactor->n; ++i) negative += entries[columns[i]] < 0;
    return negative;
  }
};

/// Values below `bound`, by Sylvester's law of inertia.
Index values_below(const SparseMatrix& stiffness, const SparseMatrix& mass, double bound) {
  const SignedFactors factors(stiffness - bound * mass);
  return factors.info() == Eigen::Success ? factors.negative_pivots() : 0;
}

/// (K - shift M)^-1 as Spectra asks for it.
class ShiftInvert {
 public:
  using Scalar = double;
  ShiftInvert(const SparseMatrix& stiffness, const SparseMatrix& mass, const Interruption& interruption)
      : stiffness_(stiffness), mass_(mass), interruption_(interruption) {}
  Index rows() const { return stiffness_.rows(); }
  Index cols() const { return stiffness_.cols(); }
  void set_shift(double shift) {
    if (!solver_.factorize(stiffness_ - shift * mass_).regular)
      throw NoModes("the stiffness cannot be factorized");
  }
  void perform_op(const double* x, double* y) const {
    if (interruption_) interruption_();
    Eigen::Map<VectorXd>(y, rows()) = solver_.solve(Eigen::Map<const VectorXd>(x, rows()));
  }

 private:
  const SparseMatrix &stiffness_, &mass_;
  const Interruption& interruption_;
  SparseSolver solver_{LinearSolver::direct};
};

/// K and its inverse as Spectra asks for them.
class Inner {
 public:
  using Scalar = double;
  Inner(const SparseMatrix& stiffness, const Interruption& interruption)
      : stiffness_(stiffness), interruption_(interruption) {
    const SparseSolver::Factors factors = solver_.factorize(stiffness);
    if (!factors.regular || !factors.positive_definite)
      throw NoModes("the state from which the load grows is not stable, or a body is not held");
  }
  Index rows() const { return stiffness_.rows(); }
  Index cols() const { return stiffness_.cols(); }
  void solve(const double* x, double* y) const {
    if (interruption_) interruption_();
    Eigen::Map<VectorXd>(y, rows()) = solver_.solve(Eigen::Map<const VectorXd>(x, rows()));
  }
  void perform_op(const double* x, double* y) const {
    Eigen::Map<VectorXd>(y, rows()) = stiffness_ * Eigen::Map<const VectorXd>(x, rows());
  }

 private:
  const SparseMatrix& stiffness_;
  const Interruption& interruption_;
  SparseSolver solver_{LinearSolver::direct};
};

/// Vectors that Lanczos keeps to find so many of `rows` values.
Index subspace(Index wanted, Index rows) { return std::min(rows, std::max<Index>(2 * wanted + 1, wanted + 20)); }

/// Copies what a solver has found.
template <class Solver>
void collect(const Solver& solver, std::vector<Eigenmode>& modes) {
  const auto values = solver.eigenvalues();
  const auto vectors = solver.eigenvectors();
  for (Index i = 0; i < values.size(); ++i) modes.push_back({values[i], vectors.col(i), 0, false});
}

/// The Lanczos vectors are not finite.
class Breakdown : public NoModes {
 public:
  using NoModes::NoModes;
};

std::vector<Eigenmode> nearest_zero(const SparseMatrix& stiffness, const SparseMatrix& mass, Index count,
                                    double shift, const Interruption& interruption) {
  ShiftInvert inverse(stiffness, mass, interruption);
  Spectra::SparseSymMatProd<double> product(mass);
  Spectra::SymGEigsShiftSolver<ShiftInvert, Spectra::SparseSymMatProd<double>, Spectra::GEigsMode::ShiftInvert>
      solver(inverse, product, count, subspace(count, stiffness.rows()), shift);
  solver.init();
  try {
    solver.compute(Spectra::SortRule::LargestMagn, most_restarts, tolerance, Spectra::SortRule::SmallestAlge);
  } catch (const std::runtime_error& error) {
    // Spectra has no type of its own for it.
    if (typeid(error) == typeid(std::runtime_error)) throw Breakdown(error.what());
    throw;
  }
  if (solver.info() != Spectra::CompInfo::Successful) throw NoModes("the Lanczos iteration does not converge");
  std::vector<Eigenmode> modes;
  collect(solver, modes);
  return modes;
}

/// The stiffness with next to nothing of the lumped mass on its diagonal. Where particles are fewer than nodes,
/// grids have motions that no particle feels, without mass and without stiffness, and any multiple of them may be
/// in a mode.
SparseMatrix without_idle_motions(const SparseMatrix& stiffness, const SparseMatrix& mass, double scale) {
  constexpr double share = 1e-13;
  SparseMatrix held = stiffness;
  held.diagonal() += share * scale * (mass * VectorXd::Ones(mass.rows()));
  return held;
}

void finish(std::vector<Eigenmode>& modes, const SparseMatrix& stiffness, const SparseMatrix& mass, double scale) {
  for (Eigenmode& mode : modes) {
    const VectorXd inertia = mass * mode.shape;
    mode.shape /= std::sqrt(mode.shape.dot(inertia));
    mode.rigid = std::abs(mode.value) < zero_share * scale;
    const VectorXd rest = stiffness * mode.shape - mode.value * (mass * mode.shape);
    mode.residual = rest.norm() / ((mode.rigid ? scale : std::abs(mode.value)) * (mass * mode.shape).norm());
  }
  std::ranges::sort(modes, {}, &Eigenmode::value);
}

std::vector<Eigenmode> search(const SparseMatrix& stiffness, const SparseMatrix& mass, Index wanted, double scale,
                              const Interruption& interruption) {
  const Index rows = stiffness.rows();
  const double shift = shift_share * scale;
  std::vector<Eigenmode> modes;
  for (int attempt = 0; attempt < 3; ++attempt) {
    modes = nearest_zero(stiffness, mass, wanted, -shift, interruption);
    finish(modes, stiffness, mass, scale);
    const double last = modes.back().value;
    const Index below = values_below(stiffness, mass, last * (1 - 1e-6) - shift);
    const auto found =
        std::ranges::count_if(modes, [&](const Eigenmode& m) { return m.value < last * (1 - 1e-6) - shift; });
    if (below <= found || wanted == rows - 1) break;
    wanted = std::min<Index>(wanted + below - found, rows - 1);
  }
  return modes;
}

}  // namespace

std::vector<Eigenmode> lowest_modes(const SparseMatrix& stiffness, const SparseMatrix& mass, int count,
                                    const Interruption& interruption) {
  const Index rows = stiffness.rows(), wanted = std::min<Index>(count, rows - 1);
  if (wanted < 1) throw NoModes("nothing is free to move");
  const double scale = value_scale(stiffness, mass);
  std::vector<Eigenmode> modes;
  try {
    modes = search(stiffness, mass, wanted, scale, interruption);
  } catch (const Breakdown&) {
    modes = search(without_idle_motions(stiffness, mass, scale), mass, wanted, scale, interruption);
    // Rayleigh's quotient is off by the square of what the shape is.
    for (Eigenmode& mode : modes) mode.value = mode.shape.dot(stiffness * mode.shape);
    finish(modes, stiffness, mass, scale);
  }
  if (static_cast<int>(modes.size()) > count) modes.resize(static_cast<std::size_t>(count));
  return modes;
}

std::vector<Eigenmode> critical_factors(const SparseMatrix& stiffness, const SparseMatrix& geometric, int count,
                                        const Interruption& interruption) {
  const Index rows = stiffness.rows(), wanted = std::min<Index>(count, rows - 1);
  if (wanted < 1) throw NoModes("nothing is free to move");
  const SparseMatrix falling = -geometric;
  Spectra::SparseSymMatProd<double> product(falling);
  Inner inner(stiffness, interruption);
  Spectra::SymGEigsSolver<Spectra::SparseSymMatProd<double>, Inner, Spectra::GEigsMode::RegularInverse> solver(
      product, inner, wanted, subspace(wanted, rows));
  solver.init();
  solver.compute(Spectra::SortRule::LargestAlge, most_restarts, tolerance);
  if (solver.info() != Spectra::CompInfo::Successful) throw NoModes("the Lanczos iteration does not converge");
  std::vector<Eigenmode> modes;
  collect(solver, modes);
  std::erase_if(modes, [](const Eigenmode& mode) { return mode.value <= 0; });
  for (Eigenmode& mode : modes) {
    mode.value = 1 / mode.value;
    const VectorXd stiff = stiffness * mode.shape;
    mode.residual = (stiff + mode.value * (geometric * mode.shape)).norm() / stiff.norm();
    mode.shape /= std::sqrt(mode.shape.dot(stiff));
  }
  return modes;
}

}  // namespace trajan
