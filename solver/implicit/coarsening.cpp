#include "solver/implicit/coarsening.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace trajan {
namespace {

/// Calls of(place, weight) for what a place is interpolated from: along each axis the node itself, or its two
/// neighbours by halves.
template <class Of>
void for_each_parent(const Place& place, Of&& of) {
  int parents[3];
  for (std::size_t axis = 0; axis < 3; ++axis) parents[axis] = 1 + (place.node[axis] & 1);
  const double weight = 1.0 / (parents[0] * parents[1] * parents[2]);
  for (int k = 0; k < parents[2]; ++k)
    for (int j = 0; j < parents[1]; ++j)
      for (int i = 0; i < parents[0]; ++i) {
        // Shifts round down, below zero too.
        const Place parent{{(place.node[0] >> 1) + i, (place.node[1] >> 1) + j, (place.node[2] >> 1) + k},
                           place.component};
        of(parent, weight);
      }
}

bool comes_before(const Place& a, const Place& b) {
  return std::tie(a.node[2], a.node[1], a.node[0], a.component) <
         std::tie(b.node[2], b.node[1], b.node[0], b.component);
}

/// A sparse vector that is summed up out of order.
class Sum {
 public:
  explicit Sum(Eigen::Index size) : values_(static_cast<std::size_t>(size)), seen_(values_.size()) {}
  void add(int at, double value) {
    const auto i = static_cast<std::size_t>(at);
    if (!seen_[i]) entries_.push_back(at), seen_[i] = 1;
    values_[i] += value;
  }
  std::vector<int>& entries() { return entries_; }
  double operator[](int at) const { return values_[static_cast<std::size_t>(at)]; }
  void clear() {
    for (const int at : entries_)
      values_[static_cast<std::size_t>(at)] = 0, seen_[static_cast<std::size_t>(at)] = 0;
    entries_.clear();
  }

 private:
  std::vector<double> values_;
  std::vector<char> seen_;
  std::vector<int> entries_;
};

}  // namespace

Coarsening coarsen(const Places& fine) {
  Coarsening result;
  Places& coarse = result.places;
  for (const Place& place : fine)
    if (std::ranges::none_of(place.node, [](std::int32_t i) { return i & 1; }))
      for_each_parent(place, [&](const Place& parent, double) { coarse.push_back(parent); });
  std::ranges::sort(coarse, comes_before);
  // Nodes whose own place is not an unknown of the finer grid.
  Places others;
  for (const Place& place : fine)
    for_each_parent(place, [&](const Place& parent, double) {
      if (!std::ranges::binary_search(coarse, parent, comes_before)) others.push_back(parent);
    });
  std::ranges::sort(others, comes_before);
  others.erase(std::unique(others.begin(), others.end()), others.end());
  const auto middle = static_cast<std::ptrdiff_t>(coarse.size());
  coarse.insert(coarse.end(), others.begin(), others.end());
  std::inplace_merge(coarse.begin(), coarse.begin() + middle, coarse.end(), comes_before);

  Interpolation& interpolation = result.interpolation;
  interpolation.resize(static_cast<Eigen::Index>(fine.size()), static_cast<Eigen::Index>(coarse.size()));
  interpolation.reserve(static_cast<Eigen::Index>(4 * fine.size()));
  for (std::size_t row = 0; row < fine.size(); ++row) {
    interpolation.startVec(static_cast<Eigen::Index>(row));
    for_each_parent(fine[row], [&](const Place& parent, double weight) {
      const auto column = std::ranges::lower_bound(coarse, parent, comes_before) - coarse.begin();
      interpolation.insertBack(static_cast<Eigen::Index>(row), column) = weight;
    });
  }
  interpolation.finalize();
  return result;
}

Eigen::SparseMatrix<double> galerkin(const Eigen::SparseMatrix<double>& matrix, const Interpolation& interpolation,
                                     const Interpolation& restriction) {
  Eigen::SparseMatrix<double> result(restriction.rows(), restriction.rows());
  result.reserve(
      static_cast<Eigen::Index>(static_cast<double>(matrix.nonZeros()) * static_cast<double>(result.cols()) /
                                static_cast<double>(matrix.cols())));
  Sum fine(matrix.rows()), coarse(result.rows());
  for (int column = 0; column < result.cols(); ++column) {
    for (Interpolation::InnerIterator of(restriction, column); of; ++of)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, of.index()); entry; ++entry)
        fine.add(static_cast<int>(entry.index()), of.value() * entry.value());
    for (const int row : fine.entries())
      for (Interpolation::InnerIterator to(interpolation, row); to; ++to)
        coarse.add(static_cast<int>(to.index()), to.value() * fine[row]);
    fine.clear();
    std::ranges::sort(coarse.entries());
    result.startVec(column);
    for (const int row : coarse.entries()) result.insertBack(row, column) = coarse[row];
    coarse.clear();
  }
  result.finalize();
  return result;
}

}  // namespace trajan
