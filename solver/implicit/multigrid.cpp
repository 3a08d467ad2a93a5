#include "solver/implicit/multigrid.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

namespace trajan {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// Unknowns of the coarsest grid at most, if coarser ones have fewer.
constexpr Eigen::Index most_coarsest = 4000;
/// Less is no coarsening.
constexpr double least_coarsening = 0.7;
/// Of the coarsest grid's diagonal. Its functions may depend on each other where bodies fill few nodes; what the
/// matrix makes of their differences is then rounding, and interpolates to nothing.
constexpr double shift = 1e-13;

int entries_of(const Matrix& matrix, int row) {
  return matrix.outerIndexPtr()[row + 1] - matrix.outerIndexPtr()[row];
}

bool have_same_columns(const Matrix& matrix, int first, int rows) {
  const int* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[first];
  const int count = entries_of(matrix, first);
  for (int row = first + 1; row < first + rows; ++row) {
    const int* other = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row];
    if (entries_of(matrix, row) != count || !std::equal(begin, begin + count, other)) return false;
  }
  return true;
}

}  // namespace

bool Multigrid::build(const Matrix& matrix, const Places& places, const Eigen::VectorXd& scale) {
  finest_ = &matrix;
  levels_.clear();
  Places finer = places;
  Matrix next;
  for (std::size_t level = 0;; ++level) {
    levels_.emplace_back();
    levels_[level].matrix.swap(next);
    if (!find_nodes(level, finer)) return false;
    Coarsening coarsening = coarsen(finer);
    Interpolation& interpolation = levels_[level].interpolation;
    interpolation.swap(coarsening.interpolation);
    if (level == 0) interpolation = scale.cwiseInverse().asDiagonal() * interpolation;
    next = galerkin(this->matrix(level), interpolation);
    const auto rows = static_cast<double>(finer.size()), coarse = static_cast<double>(coarsening.places.size());
    finer = std::move(coarsening.places);
    if (next.rows() <= most_coarsest || coarse > least_coarsening * rows) break;
  }
  return factorize_coarsest(std::move(next));
}

bool Multigrid::find_nodes(std::size_t level, const Places& places) {
  const Matrix& of = matrix(level);
  std::vector<Node>& nodes = levels_[level].nodes;
  std::size_t longest = gathered_.size();
  for (int first = 0, rows; first < of.rows(); first += rows) {
    const auto at = static_cast<std::size_t>(first);
    for (rows = 1; at + static_cast<std::size_t>(rows) < places.size(); ++rows)
      if (places[at + static_cast<std::size_t>(rows)].node != places[at].node) break;
    Node node{first, rows, have_same_columns(of, first, rows), 0, {}};
    const int* columns = of.innerIndexPtr() + of.outerIndexPtr()[first];
    const int count = entries_of(of, first);
    node.below = static_cast<int>(std::lower_bound(columns, columns + count, first) - columns);
    longest = std::max(longest, static_cast<std::size_t>(count));
    Eigen::MatrixXd block(rows, rows);
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < rows; ++j) block(i, j) = of.coeff(first + i, first + j);
    const Eigen::LLT<Eigen::MatrixXd> factor(block);
    if (factor.info() != Eigen::Success) return false;
    const Eigen::MatrixXd inverse = factor.solve(Eigen::MatrixXd::Identity(rows, rows));
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < rows; ++j)
        node.inverse[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = inverse(i, j);
    nodes.push_back(node);
  }
  gathered_.resize(longest);
  return true;
}

bool Multigrid::factorize_coarsest(Matrix matrix) {
  coarsest_scale_ = matrix.diagonal();
  if (!(coarsest_scale_.minCoeff() > 0)) return false;
  coarsest_scale_ = coarsest_scale_.cwiseSqrt().cwiseInverse();
  matrix = coarsest_scale_.asDiagonal() * matrix * coarsest_scale_.asDiagonal();
  coarsest_.setShift(shift);
  coarsest_.compute(matrix);
  if (coarsest_.info() != Eigen::Success) return false;
  reciprocal_condition_ = coarsest_.reciprocal_condition();
  return true;
}

template <Multigrid::Part part>
Multigrid::Rows Multigrid::product(const Matrix& matrix, const Node& node, const Eigen::VectorXd& x) {
  using Values = Eigen::Map<const Eigen::VectorXd>;
  const int* columns = matrix.innerIndexPtr();
  Rows result{};
  if (node.alike) {
    const int begin = matrix.outerIndexPtr()[node.first], count = entries_of(matrix, node.first);
    const int from = part == Part::after_node ? node.below + node.rows : 0;
    const int size = (part == Part::before_node ? node.below : count) - from;
    for (int k = 0; k < size; ++k) gathered_[static_cast<std::size_t>(k)] = x[columns[begin + from + k]];
    const Values gathered(gathered_.data(), size);
    for (int i = 0; i < node.rows; ++i)
      result[static_cast<std::size_t>(i)] =
          Values(matrix.valuePtr() + begin + i * count + from, size).dot(gathered);
    return result;
  }
  for (int i = 0; i < node.rows; ++i)
    for (Matrix::InnerIterator entry(matrix, node.first + i); entry; ++entry) {
      const bool counts = part == Part::whole || (part == Part::before_node && entry.index() < node.first) ||
                          (part == Part::after_node && entry.index() >= node.first + node.rows);
      if (counts) result[static_cast<std::size_t>(i)] += entry.value() * x[entry.index()];
    }
  return result;
}

Multigrid::Rows Multigrid::solve(const Node& node, const Eigen::VectorXd& right, const Rows& known) {
  Rows result{};
  for (std::size_t j = 0; j < static_cast<std::size_t>(node.rows); ++j) {
    const double left = right[node.first + static_cast<int>(j)] - known[j];
    for (std::size_t i = 0; i < 3; ++i) result[i] += node.inverse[i][j] * left;
  }
  return result;
}

void Multigrid::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  y.resize(x.size());
  for (const Node& node : levels_[0].nodes) {
    const Rows rows = product<Part::whole>(*finest_, node, x);
    std::copy_n(rows.begin(), node.rows, y.data() + node.first);
  }
}

/// The sweep forwards begins with zero, and what is left of the residual after it are the products with entries
/// after a node's.
void Multigrid::cycle(std::size_t number, const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  if (number == levels_.size()) {
    z = coarsest_scale_.cwiseProduct(coarsest_.solve(coarsest_scale_.cwiseProduct(r)));
    return;
  }
  Level& level = levels_[number];
  const Matrix& of = matrix(number);
  z.resize(r.size());
  level.rest.resize(r.size());
  for (const Node& node : level.nodes) {
    const Rows rows = solve(node, r, product<Part::before_node>(of, node, z));
    std::copy_n(rows.begin(), node.rows, z.data() + node.first);
  }
  for (const Node& node : level.nodes) {
    const Rows rows = product<Part::after_node>(of, node, z);
    for (int i = 0; i < node.rows; ++i) level.rest[node.first + i] = -rows[static_cast<std::size_t>(i)];
  }
  level.right = level.interpolation.transpose() * level.rest;
  cycle(number + 1, level.right, level.answer);
  z += level.interpolation * level.answer;
  for (auto node = level.nodes.rbegin(); node != level.nodes.rend(); ++node) {
    const Rows rows = solve(*node, r, product<Part::whole>(of, *node, z));
    for (int i = 0; i < node->rows; ++i) z[node->first + i] += rows[static_cast<std::size_t>(i)];
  }
}

}  // namespace trajan
