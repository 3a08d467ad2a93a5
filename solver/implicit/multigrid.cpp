#include "solver/implicit/multigrid.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <utility>

namespace trajan {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// Unknowns of the coarsest grid at most, if coarser ones have fewer.
constexpr Eigen::Index most_coarsest = 2000;
/// Less is no coarsening.
constexpr double least_coarsening = 0.7;
/// Of the coarsest grid's diagonal. Its functions may depend on each other where bodies fill few nodes; what the
/// matrix makes of their differences is then rounding, and interpolates to nothing.
constexpr double shift = 1e-13;

/// Threads meet after each half of a sweep. On a busy machine they wait for each other as long as many small
/// sweeps take: matrices with fewer entries have one.
constexpr Eigen::Index least_entries = 300'000;
constexpr std::size_t least_slab = 64;
/// Nodes of a piece, rows that are interpolated.
constexpr std::size_t most_of_piece = 256;
constexpr Eigen::Index rows_of_piece = 1024;

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
    find_slabs(level);
    Coarsening coarsening = coarsen(finer);
    Interpolation& interpolation = levels_[level].interpolation;
    interpolation.swap(coarsening.interpolation);
    if (level == 0) interpolation = scale.cwiseInverse().asDiagonal() * interpolation;
    levels_[level].restriction = interpolation.transpose();
    next = galerkin(this->matrix(level), interpolation, levels_[level].restriction);
    const auto rows = static_cast<double>(finer.size()), coarse = static_cast<double>(coarsening.places.size());
    finer = std::move(coarsening.places);
    if (next.rows() <= most_coarsest || coarse > least_coarsening * rows) break;
  }
  return factorize_coarsest(std::move(next));
}

bool Multigrid::find_nodes(std::size_t level, const Places& places) {
  const Matrix& of = matrix(level);
  std::vector<Node>& nodes = levels_[level].nodes;
  std::size_t longest = gathered_[0].size();
  for (int first = 0, rows; first < of.rows(); first += rows) {
    const auto at = static_cast<std::size_t>(first);
    for (rows = 1; at + static_cast<std::size_t>(rows) < places.size(); ++rows)
      if (places[at + static_cast<std::size_t>(rows)].node != places[at].node) break;
    Node node{first, rows, have_same_columns(of, first, rows), 0, 0, 0, {}};
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
  for (std::vector<double>& gathered : gathered_) gathered.resize(longest);
  return true;
}

/// A slab ends where neither the nodes after it have entries in the slabs before it, nor the other way round.
void Multigrid::find_slabs(std::size_t number) {
  Level& level = levels_[number];
  const Matrix& of = matrix(number);
  std::vector<Node>& nodes = level.nodes;
  level.large = of.nonZeros() >= least_entries;
  // The lowest column of the nodes from here on, and the highest of those before.
  std::vector<int> lowest(nodes.size() + 1, static_cast<int>(of.rows())), highest(nodes.size() + 1, -1);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    highest[n + 1] = highest[n];
    for (int row = nodes[n].first; row < nodes[n].first + nodes[n].rows; ++row) {
      lowest[n] = std::min(lowest[n], of.innerIndexPtr()[of.outerIndexPtr()[row]]);
      highest[n + 1] = std::max(highest[n + 1], of.innerIndexPtr()[of.outerIndexPtr()[row + 1] - 1]);
    }
  }
  for (std::size_t n = nodes.size(); n-- > 0;) lowest[n] = std::min(lowest[n], lowest[n + 1]);
  const auto column = [&](std::size_t n) {
    return n < nodes.size() ? nodes[n].first : static_cast<int>(of.rows());
  };
  for (std::size_t begin = 0, end; begin < nodes.size(); begin = end) {
    for (end = std::min(begin + least_slab, nodes.size()); end < nodes.size(); ++end)
      if (lowest[end] >= std::max(column(begin), 1) && highest[begin] < column(end)) break;
    for (std::size_t n = begin; n < end; n += most_of_piece)
      level.pieces.push_back({level.slabs.size(), n, std::min(n + most_of_piece, end)});
    level.slabs.push_back({begin, end, column(begin), column(end), level.slabs.size() % 2 == 1});
    for (std::size_t n = begin; n < end; ++n) {
      const int* columns = of.innerIndexPtr() + of.outerIndexPtr()[nodes[n].first];
      const auto before = [&](int border) {
        return static_cast<int>(std::lower_bound(columns, columns + entries_of(of, nodes[n].first), border) -
                                columns);
      };
      nodes[n].before_slab = before(column(begin));
      nodes[n].to_slab_end = before(column(end));
    }
  }
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

template <class Of>
void Multigrid::share(const Level& level, std::size_t count, Of&& of) {
  if (!level.large) {
    for (std::size_t i = 0; i < count; ++i) of(i, gathered_[0].data());
    return;
  }
  std::atomic<std::size_t> next = 0;
  pool_.run([&](int thread) {
    double* gathered = gathered_[static_cast<std::size_t>(thread)].data();
    for (std::size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) of(i, gathered);
  });
}

template <class To>
void Multigrid::interpolate(const Level& level, const Interpolation& by, const Eigen::VectorXd& x, To&& to) {
  share(level, static_cast<std::size_t>((by.rows() + rows_of_piece - 1) / rows_of_piece),
        [&](std::size_t i, double*) {
          const Eigen::Index begin = static_cast<Eigen::Index>(i) * rows_of_piece;
          for (Eigen::Index row = begin; row < std::min(begin + rows_of_piece, by.rows()); ++row) {
            double sum = 0;
            for (Interpolation::InnerIterator entry(by, row); entry; ++entry)
              sum += entry.value() * x[entry.index()];
            to(row, sum);
          }
        });
}

template <Multigrid::Part part>
Multigrid::Rows Multigrid::product(const Matrix& matrix, const Node& node, const Slab& slab,
                                   const Eigen::VectorXd& x, double* gathered) {
  using Values = Eigen::Map<const Eigen::VectorXd>;
  Rows result{};
  const int after = node.below + node.rows;
  if (node.alike) {
    const int begin = matrix.outerIndexPtr()[node.first], count = entries_of(matrix, node.first);
    const int* columns = matrix.innerIndexPtr() + begin;
    const auto add = [&](int from, int to) {
      for (int k = from; k < to; ++k) gathered[k - from] = x[columns[k]];
      for (int i = 0; i < node.rows; ++i)
        result[static_cast<std::size_t>(i)] +=
            Values(matrix.valuePtr() + begin + i * count + from, to - from).dot(Values(gathered, to - from));
    };
    if (part == Part::whole) {
      add(0, count);
    } else if (part == Part::before_node) {
      add(slab.odd ? 0 : node.before_slab, node.below);
      if (slab.odd && node.to_slab_end < count) add(node.to_slab_end, count);
    } else {
      add(after, slab.odd ? node.to_slab_end : count);
      if (!slab.odd && node.before_slab > 0) add(0, node.before_slab);
    }
    return result;
  }
  const auto counts = [&](Eigen::Index column) {
    if (part == Part::whole) return true;
    if (column >= node.first && column < node.first + node.rows) return false;
    const bool within = column >= slab.first && column < slab.last;
    return (part == Part::before_node) == (within ? column < node.first : slab.odd);
  };
  for (int i = 0; i < node.rows; ++i)
    for (Matrix::InnerIterator entry(matrix, node.first + i); entry; ++entry)
      if (counts(entry.index())) result[static_cast<std::size_t>(i)] += entry.value() * x[entry.index()];
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
  const Level& level = levels_[0];
  share(level, level.pieces.size(), [&](std::size_t i, double* gathered) {
    const Piece& piece = level.pieces[i];
    for (std::size_t n = piece.begin; n < piece.end; ++n) {
      const Node& node = level.nodes[n];
      const Rows rows = product<Part::whole>(*finest_, node, level.slabs[piece.slab], x, gathered);
      std::copy_n(rows.begin(), node.rows, y.data() + node.first);
    }
  });
}

void Multigrid::sweep_forwards(std::size_t number, const Slab& slab, const Eigen::VectorXd& r, Eigen::VectorXd& z,
                               double* gathered) const {
  for (std::size_t n = slab.begin; n < slab.end; ++n) {
    const Node& node = levels_[number].nodes[n];
    const Rows rows = solve(node, r, product<Part::before_node>(matrix(number), node, slab, z, gathered));
    std::copy_n(rows.begin(), node.rows, z.data() + node.first);
  }
}

void Multigrid::sweep_backwards(std::size_t number, const Slab& slab, const Eigen::VectorXd& r, Eigen::VectorXd& z,
                                double* gathered) const {
  for (std::size_t n = slab.end; n-- > slab.begin;) {
    const Node& node = levels_[number].nodes[n];
    const Rows rows = solve(node, r, product<Part::whole>(matrix(number), node, slab, z, gathered));
    for (int i = 0; i < node.rows; ++i) z[node.first + i] += rows[static_cast<std::size_t>(i)];
  }
}

/// The sweep forwards begins with zero, and what is left of the residual after it are the products with entries
/// of nodes after a row's.
void Multigrid::cycle(std::size_t number, const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  if (number == levels_.size()) {
    z = coarsest_scale_.cwiseProduct(coarsest_.solve(coarsest_scale_.cwiseProduct(r)));
    return;
  }
  Level& level = levels_[number];
  z.resize(r.size());
  level.rest.resize(r.size());
  const std::size_t slabs = level.slabs.size(), even = (slabs + 1) / 2;
  const auto forwards = [&](std::size_t slab, double* gathered) {
    sweep_forwards(number, level.slabs[slab], r, z, gathered);
  };
  const auto backwards = [&](std::size_t slab, double* gathered) {
    sweep_backwards(number, level.slabs[slab], r, z, gathered);
  };
  share(level, even, [&](std::size_t i, double* gathered) { forwards(2 * i, gathered); });
  share(level, slabs - even, [&](std::size_t i, double* gathered) { forwards(2 * i + 1, gathered); });
  share(level, level.pieces.size(), [&](std::size_t i, double* gathered) {
    const Piece& piece = level.pieces[i];
    for (std::size_t n = piece.begin; n < piece.end; ++n) {
      const Node& node = level.nodes[n];
      const Rows rows = product<Part::after_node>(matrix(number), node, level.slabs[piece.slab], z, gathered);
      for (int k = 0; k < node.rows; ++k) level.rest[node.first + k] = -rows[static_cast<std::size_t>(k)];
    }
  });
  level.right.resize(level.restriction.rows());
  interpolate(level, level.restriction, level.rest,
              [&](Eigen::Index row, double value) { level.right[row] = value; });
  cycle(number + 1, level.right, level.answer);
  interpolate(level, level.interpolation, level.answer, [&](Eigen::Index row, double value) { z[row] += value; });
  share(level, slabs - even, [&](std::size_t i, double* gathered) { backwards(2 * i + 1, gathered); });
  share(level, even, [&](std::size_t i, double* gathered) { backwards(2 * i, gathered); });
}

}  // namespace trajan
