#include "solver/implicit/sparse_solver.h"

#include <dlfcn.h>

#include <Eigen/CholmodSupport>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace trajan {
namespace {

/// Below this the factors' diagonal holds nothing but rounding.
constexpr double singular = 1e-15;
/// Differences between a matrix and its transpose below this share of its largest entry are rounding.
constexpr double asymmetry = 1e-11;
/// Bytes of factors from which on conjugate gradients are taken. Not what this machine has left: bits must not
/// depend on that.
constexpr double most_bytes = 4e9;
/// Non-zeros of a matrix whose factors are not even sized up: in three dimensions they take some hundred times as
/// many bytes.
constexpr Eigen::Index most_entries = 60'000'000;

/// Supernodal Cholesky (Chen, Davis, Hager and Rajamanickam 2008).
class Cholesky : public Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> {
 public:
  Cholesky() { cholmod().print = 0; }
  double reciprocal_condition() { return cholmod_rcond(m_cholmodFactor, &cholmod()); }
  /// Of the factor, once the pattern has been analyzed.
  double bytes() const {
    if (m_cholmodFactor == nullptr) return std::numeric_limits<double>::infinity();
    return sizeof(double) * static_cast<double>(m_cholmodFactor->xsize);
  }
};

/// Unsymmetric multifrontal LU (Davis 2004).
class Lu : public Eigen::UmfPackLU<SparseMatrix> {
 public:
  double reciprocal_condition() const { return m_umfpackInfo[UMFPACK_RCOND]; }
};

/// Preconditioned with an incomplete factor, which is as full as the matrix. Nodes keep their order, by tiles: to
/// find another one takes more memory than the factor.
using IncompleteCholesky =
    Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper,
                             Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>>>;

bool same_pattern(const SparseMatrix& a, const SparseMatrix& b) {
  return a.rows() == b.rows() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

/// Walks down the lower half of all columns at once, as the columns come by whose upper halves should be the same.
bool is_symmetric(const SparseMatrix& matrix) {
  const int* row = matrix.innerIndexPtr();
  const double* value = matrix.valuePtr();
  std::vector<int> at(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.outerSize());
  double difference = 0, largest = 0;
  const auto differ = [&](double by) { difference = std::max(difference, std::abs(by)); };
  for (int column = 0; column < matrix.outerSize(); ++column) {
    const int end = matrix.outerIndexPtr()[column + 1];
    int e = matrix.outerIndexPtr()[column];
    for (; e < end && row[e] < column; ++e) {
      largest = std::max(largest, std::abs(value[e]));
      int& other = at[static_cast<std::size_t>(row[e])];
      const int last = matrix.outerIndexPtr()[row[e] + 1];
      while (other < last && row[other] < column) differ(value[other++]);
      const bool paired = other < last && row[other] == column;
      differ(paired ? value[e] - value[other++] : value[e]);
    }
    if (e < end && row[e] == column) largest = std::max(largest, std::abs(value[e++]));
    at[static_cast<std::size_t>(column)] = e;
    for (; e < end; ++e) largest = std::max(largest, std::abs(value[e]));
  }
  for (int column = 0; column < matrix.outerSize(); ++column)
    for (int e = at[static_cast<std::size_t>(column)]; e < matrix.outerIndexPtr()[column + 1]; ++e)
      differ(value[e]);
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

  void scale_to_unit_diagonal(SparseMatrix given);
  void analyze();
  bool factors_are_too_large();
  Factors by_cholesky();
  Factors by_lu();
  Factors by_gradients();
};

void SparseSolver::Methods::scale_to_unit_diagonal(SparseMatrix given) {
  const bool known = same_pattern(given, matrix);
  cholesky_analyzed = cholesky_analyzed && known;
  lu_analyzed = lu_analyzed && known;
  matrix = std::move(given);
  scale = matrix.diagonal().cwiseAbs();
  for (double& s : scale) s = s > 0 ? 1 / std::sqrt(s) : 1;
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
      entry.valueRef() *= scale[entry.row()] * scale[column];
}

void SparseSolver::Methods::analyze() {
  if (!cholesky_analyzed) cholesky.analyzePattern(matrix);
  cholesky_analyzed = true;
}

bool SparseSolver::Methods::factors_are_too_large() {
  if (matrix.nonZeros() > most_entries) return true;
  analyze();
  return cholesky.bytes() > most_bytes;
}

SparseSolver::Factors SparseSolver::Methods::by_cholesky() {
  analyze();
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

SparseSolver::Factors SparseSolver::factorize(SparseMatrix matrix) {
  methods_->used = Methods::Used::none;
  if (matrix.rows() == 0) return {true, true, 1};
  methods_->scale_to_unit_diagonal(std::move(matrix));
  for (Eigen::Index e = 0; e < methods_->matrix.nonZeros(); ++e)
    if (!std::isfinite(methods_->matrix.valuePtr()[e])) return {};
  if (!is_symmetric(methods_->matrix)) return methods_->by_lu();
  const bool iterative = choice_ == LinearSolver::iterative ||
                         (choice_ == LinearSolver::automatic && methods_->factors_are_too_large());
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
