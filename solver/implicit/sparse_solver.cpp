#include "solver/implicit/sparse_solver.h"

#include <dlfcn.h>

#include <Eigen/CholmodSupport>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <cmath>

namespace trajan {
namespace {

/// Below this the factors' diagonal holds nothing but rounding.
constexpr double singular = 1e-15;
/// Differences between a matrix and its transpose below this share of its largest entry are rounding.
constexpr double asymmetry = 1e-11;
/// Non-zeros of the matrix from which on factors would not fit: they take some hundred times as many bytes in
/// three dimensions.
constexpr Eigen::Index most_for_factors = 60'000'000;

/// Supernodal Cholesky (Chen, Davis, Hager and Rajamanickam 2008).
class Cholesky : public Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> {
 public:
  Cholesky() { cholmod().print = 0; }
  double reciprocal_condition() { return cholmod_rcond(m_cholmodFactor, &cholmod()); }
};

/// Unsymmetric multifrontal LU (Davis 2004).
class Lu : public Eigen::UmfPackLU<SparseMatrix> {
 public:
  double reciprocal_condition() const { return m_umfpackInfo[UMFPACK_RCOND]; }
};

using IncompleteCholesky =
    Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper, Eigen::IncompleteCholesky<double>>;

bool same_pattern(const SparseMatrix& a, const SparseMatrix& b) {
  return a.rows() == b.rows() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

bool is_symmetric(const SparseMatrix& matrix) {
  const SparseMatrix transposed = matrix.transpose();
  double difference = 0, largest = 0;
  for (Eigen::Index e = 0; e < matrix.nonZeros(); ++e) {
    difference = std::max(difference, std::abs(matrix.valuePtr()[e] - transposed.valuePtr()[e]));
    largest = std::max(largest, std::abs(matrix.valuePtr()[e]));
  }
  return difference <= asymmetry * largest;
}

/// OpenBLAS, if that is the system's BLAS, takes as many threads as there are cores and adds up differently with
/// each number of them. Others have one thread, as long as nobody asks for more.
void keep_blas_on_one_thread() {
  using SetThreads = void (*)(int);
  if (const auto set = reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))) set(1);
}

}  // namespace

struct SparseSolver::Methods {
  enum class Used { none, cholesky, lu, gradients };
  Cholesky cholesky;
  Lu lu;
  IncompleteCholesky gradients;
  Used used = Used::none;
  bool cholesky_analyzed = false, lu_analyzed = false;
  SparseMatrix matrix;  ///< scaled
  Eigen::VectorXd scale;

  void scale_to_unit_diagonal(const SparseMatrix& given);
  Factors by_cholesky();
  Factors by_lu();
  Factors by_gradients();
};

void SparseSolver::Methods::scale_to_unit_diagonal(const SparseMatrix& given) {
  const bool known = same_pattern(given, matrix);
  cholesky_analyzed = cholesky_analyzed && known;
  lu_analyzed = lu_analyzed && known;
  matrix = given;
  scale = matrix.diagonal().cwiseAbs();
  for (double& s : scale) s = s > 0 ? 1 / std::sqrt(s) : 1;
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
      entry.valueRef() *= scale[entry.row()] * scale[column];
}

SparseSolver::Factors SparseSolver::Methods::by_cholesky() {
  if (!cholesky_analyzed) cholesky.analyzePattern(matrix);
  cholesky_analyzed = true;
  cholesky.factorize(matrix);
  if (cholesky.info() != Eigen::Success) return {};
  used = Used::cholesky;
  const double condition = cholesky.reciprocal_condition();
  return {condition > singular, true, condition};
}

SparseSolver::Factors SparseSolver::Methods::by_lu() {
  if (!lu_analyzed) lu.analyzePattern(matrix);
  lu_analyzed = true;
  lu.factorize(matrix);
  if (lu.info() != Eigen::Success) return {};
  used = Used::lu;
  const double condition = lu.reciprocal_condition();
  return {condition > singular, false, condition};
}

SparseSolver::Factors SparseSolver::Methods::by_gradients() {
  gradients.compute(matrix);
  if (gradients.info() != Eigen::Success) return {};
  used = Used::gradients;
  return {true, true, 1};
}

SparseSolver::SparseSolver(LinearSolver choice) : choice_(choice), methods_(std::make_unique<Methods>()) {
  keep_blas_on_one_thread();
}
SparseSolver::~SparseSolver() = default;

SparseSolver::Factors SparseSolver::factorize(const SparseMatrix& matrix) {
  methods_->scale_to_unit_diagonal(matrix);
  methods_->used = Methods::Used::none;
  if (matrix.rows() == 0) return {true, true, 1};
  for (Eigen::Index e = 0; e < methods_->matrix.nonZeros(); ++e)
    if (!std::isfinite(methods_->matrix.valuePtr()[e])) return {};
  if (!is_symmetric(methods_->matrix)) return methods_->by_lu();
  const bool iterative = choice_ == LinearSolver::iterative ||
                         (choice_ == LinearSolver::automatic && methods_->matrix.nonZeros() > most_for_factors);
  const Factors factors = iterative ? methods_->by_gradients() : methods_->by_cholesky();
  return methods_->used == Methods::Used::none ? methods_->by_lu() : factors;
}

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& right, double tolerance) const {
  Methods& m = *methods_;
  const Eigen::VectorXd scaled = m.scale.cwiseProduct(right);
  Eigen::VectorXd x;
  if (m.used == Methods::Used::cholesky) x = m.cholesky.solve(scaled);
  if (m.used == Methods::Used::lu) x = m.lu.solve(scaled);
  if (m.used == Methods::Used::gradients) {
    m.gradients.setTolerance(tolerance);
    x = m.gradients.solve(scaled);
  }
  return m.used == Methods::Used::none ? right : Eigen::VectorXd(m.scale.cwiseProduct(x));
}

}  // namespace trajan
