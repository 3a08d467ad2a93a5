#include "solver/implicit/sparse_solver.h"

#include <dlfcn.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/implicit/cholesky.h"
#include "solver/implicit/conjugate_gradients.h"
#include "solver/implicit/equations.h"
#include "solver/implicit/multigrid.h"

namespace trajan {
namespace {

/// Below this the factors' diagonal holds nothing but rounding.
constexpr double singular = 1e-15;
/// Differences between a matrix and its transpose below this share of its largest entry are rounding.
constexpr double asymmetry = 1e-11;
/// Bytes of factors from which on conjugate gradients are taken. Not what this machine has left: bits must not
/// depend on that. They take the assembled matrix, too. Counted for linear functions in space and 8 particles in a
/// cell, its 81 entries a row are 972 bytes and 81 products for each unknown. Products without it, over particles,
/// read tangents, gradients and nodes (872 bytes) and take 225 products for each of 8/3 particles: 2325 bytes and
/// 600 products; and sweeps need rows. A cube of 68^3 cells takes 4.9 GB (measured): 0.6 particles, 1.2 what they
/// see of the grid, 1.8 their tangents, gradients and forces, 0.9 the matrix, 0.3 multigrid.
constexpr double most_bytes = 4e9;
/// Non-zeros of a matrix whose factors are not even sized up: in three dimensions they take some hundred times as
/// many bytes.
constexpr Eigen::Index most_entries = 60'000'000;
/// Cycles at most, and those after which it is asked whether these will do.
constexpr int most_cycles = 300, trial_cycles = 60;
/// With an incomplete factor.
constexpr int most_iterations = 5000;

/// Unsymmetric multifrontal LU (Davis 2004).
class Lu : public Eigen::UmfPackLU<SparseMatrix> {
 public:
  double reciprocal_condition() const { return m_umfpackInfo[UMFPACK_RCOND]; }
};

/// What conjugate gradients need where nothing is known but the matrix: an incomplete factor, which is as full as
/// it. Nodes keep their order, by tiles: to find another one takes more memory than the factor.
struct IncompleteFactor {
  const SparseMatrix& matrix;
  Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>> factor;

  explicit IncompleteFactor(const SparseMatrix& of) : matrix(of), factor(of) {}
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const { y = matrix.transpose() * x; }
  void precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) const { z = factor.solve(r); }
};

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

double factor_work_of(const Places& places) {
  std::array<std::int32_t, 3> lowest, highest;
  lowest.fill(std::numeric_limits<std::int32_t>::max());
  highest.fill(std::numeric_limits<std::int32_t>::min());
  for (const Place& place : places)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lowest[axis] = std::min(lowest[axis], place.node[axis]);
      highest[axis] = std::max(highest[axis], place.node[axis]);
    }
  int longest = 0, axes = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    longest = std::max(longest, highest[axis] - lowest[axis] + 1);
    axes += highest[axis] > lowest[axis];
  }
  return factor_work(static_cast<double>(places.size()), longest, axes);
}

}  // namespace

struct SparseSolver::Methods {
  enum class Used { none, cholesky, lu, multigrid, incomplete };
  ThreadPool one_thread{1};
  ThreadPool* pool = nullptr;
  Cholesky cholesky;
  Lu lu;
  std::unique_ptr<Multigrid> multigrid;
  std::unique_ptr<IncompleteFactor> incomplete;
  Used used = Used::none;
  bool cholesky_analyzed = false, lu_analyzed = false;
  SparseMatrix matrix;  ///< scaled
  Eigen::VectorXd scale;
  Factors factors;
  Eigen::VectorXd direction;  ///< along which a matrix without factors is not positive, if that is known
  int iterations = 0;

  /// Takes the memory of what is given.
  void begin(SparseMatrix& given);
  void scale_to_unit_diagonal();
  bool finite() const;
  void analyze();
  bool factors_are_too_large();
  void by_cholesky();
  void by_lu();
  void by_factors();
  void by_incomplete_factor();
  void by_multigrid(const Places& places);
  Gradients iterate(const Eigen::VectorXd& right, double tolerance, Eigen::VectorXd& x);
  void solve(const Eigen::VectorXd& right, double tolerance, Eigen::VectorXd& x);
};

void SparseSolver::Methods::begin(SparseMatrix& given) {
  used = Used::none;
  multigrid.reset();
  incomplete.reset();
  direction.resize(0);
  factors = {};
  iterations = 0;
  const bool known = same_pattern(given, matrix);
  cholesky_analyzed = cholesky_analyzed && known;
  lu_analyzed = lu_analyzed && known;
  matrix.swap(given);
  scale_to_unit_diagonal();
}

bool SparseSolver::Methods::finite() const {
  return std::all_of(matrix.valuePtr(), matrix.valuePtr() + matrix.nonZeros(),
                     [](double value) { return std::isfinite(value); });
}

void SparseSolver::Methods::scale_to_unit_diagonal() {
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

void SparseSolver::Methods::by_cholesky() {
  analyze();
  cholesky.factorize(matrix);
  if (cholesky.info() != Eigen::Success) return;
  used = Used::cholesky;
  const double condition = cholesky.reciprocal_condition();
  factors = {condition > singular, true, condition};
}

void SparseSolver::Methods::by_lu() {
  if (!lu_analyzed) lu.analyzePattern(matrix);
  lu_analyzed = true;
  lu.factorize(matrix);
  if (lu.info() != Eigen::Success) return;
  used = Used::lu;
  const double condition = lu.reciprocal_condition();
  factors = {condition > singular, false, condition};
}

void SparseSolver::Methods::by_factors() {
  used = Used::none;
  factors = {};
  by_cholesky();
  if (used == Used::none) by_lu();
}

void SparseSolver::Methods::by_incomplete_factor() {
  used = Used::none;
  incomplete = std::make_unique<IncompleteFactor>(matrix);
  if (incomplete->factor.info() != Eigen::Success) return;
  used = Used::incomplete;
  factors = {true, true, 1};
}

void SparseSolver::Methods::by_multigrid(const Places& places) {
  multigrid = std::make_unique<Multigrid>(*pool);
  if (!multigrid->build(matrix, places, scale)) return;
  used = Used::multigrid;
  factors = {true, true, multigrid->reciprocal_condition()};
}

Gradients SparseSolver::Methods::iterate(const Eigen::VectorXd& right, double tolerance, Eigen::VectorXd& x) {
  const Gradients end =
      used == Used::multigrid
          ? conjugate_gradients(*multigrid, right, tolerance, trial_cycles, most_cycles, x)
          : conjugate_gradients(*incomplete, right, tolerance, most_iterations, most_iterations, x);
  iterations += end.iterations;
  return end;
}

/// By iterations, otherwise by factors, if these are too large by other iterations, or not at all.
void SparseSolver::Methods::solve(const Eigen::VectorXd& right, double tolerance, Eigen::VectorXd& x) {
  iterations = 0;
  if (used == Used::multigrid || used == Used::incomplete) {
    Gradients end = iterate(right, tolerance, x);
    if (end.end == Gradients::End::converged) return;
    const bool factorize = !factors_are_too_large();
    if (factorize) by_factors();
    if (!factorize && used == Used::multigrid && end.end == Gradients::End::too_slow) {
      by_incomplete_factor();
      if (used != Used::none) end = iterate(right, tolerance, x);
      if (end.end == Gradients::End::converged) return;
    }
    if (!factorize) {
      used = Used::none;
      factors = {false, end.end != Gradients::End::indefinite, 0};
      direction = x;
    }
  }
  if (used == Used::cholesky) x = cholesky.solve(right);
  if (used == Used::lu) x = lu.solve(right);
  if (used == Used::none) x = direction.size() > 0 ? direction : right;
}

SparseSolver::SparseSolver(LinearSolver choice, ThreadPool* pool)
    : choice_(choice), methods_(std::make_unique<Methods>()) {
  methods_->pool = pool ? pool : &methods_->one_thread;
  keep_blas_on_one_thread();
}
SparseSolver::~SparseSolver() = default;

void SparseSolver::release() {
  Methods& m = *methods_;
  if (m.used != Methods::Used::multigrid && m.used != Methods::Used::incomplete) return;
  SparseMatrix none;
  m.begin(none);
}

const SparseSolver::Factors& SparseSolver::factors() const { return methods_->factors; }
int SparseSolver::iterations() const { return methods_->iterations; }

SparseSolver::Factors SparseSolver::factorize(SparseMatrix matrix, const Places& places) {
  Methods& m = *methods_;
  const bool narrow =
      static_cast<double>(matrix.nonZeros()) <= most_row_entries * static_cast<double>(matrix.rows());
  m.begin(matrix);
  if (m.matrix.rows() == 0) return m.factors = {true, true, 1};
  if (!m.finite()) return m.factors;
  if (!is_symmetric(m.matrix)) {
    m.by_lu();
    return m.factors;
  }
  const bool placed = !places.empty(), much = placed && narrow && factor_work_of(places) > most_factor_work;
  const bool iterative = choice_ == LinearSolver::iterative ||
                         (choice_ == LinearSolver::automatic && (much || m.factors_are_too_large()));
  if (iterative && placed) m.by_multigrid(places);
  if (iterative && !placed) m.by_incomplete_factor();
  if (m.used == Methods::Used::none && !(iterative && m.factors_are_too_large())) m.by_factors();
  return m.factors;
}

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& right, double tolerance) const {
  Methods& m = *methods_;
  Eigen::VectorXd x;
  m.solve(m.scale.cwiseProduct(right), tolerance, x);
  return m.scale.cwiseProduct(x);
}

}  // namespace trajan
