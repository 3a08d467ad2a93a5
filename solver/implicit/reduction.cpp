#include "solver/implicit/reduction.h"

#include <vector>

namespace trajan {
namespace {

/// Of each unknown which free one it is, -1: none. Empty: there are other combinations.
std::vector<int> selection(const SparseMatrix& expand) {
  std::vector<int> which(static_cast<std::size_t>(expand.rows()), -1);
  for (int column = 0; column < expand.cols(); ++column) {
    int entries = 0;
    for (SparseMatrix::InnerIterator entry(expand, column); entry; ++entry, ++entries) {
      if (entry.value() != 1) return {};
      which[static_cast<std::size_t>(entry.row())] = column;
    }
    if (entries != 1) return {};
  }
  return which;
}

}  // namespace

/// Most often conditions hold nodes and the others are as they were: then rows and columns are left out, which
/// needs no memory beside the result.
SparseMatrix reduced(const SparseMatrix& matrix, const SparseMatrix& expand) {
  const std::vector<int> which = selection(expand);
  if (which.empty()) {
    const SparseMatrix half = matrix * expand;
    return SparseMatrix(expand.transpose()) * half;
  }
  SparseMatrix result(expand.cols(), expand.cols());
  Eigen::Index entries = 0;
  const auto free = [&](Eigen::Index unknown) { return which[static_cast<std::size_t>(unknown)]; };
  const auto for_each_entry = [&](Eigen::Index column, auto&& of) {
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
      if (free(entry.row()) >= 0) of(free(entry.row()), entry.value());
  };
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
    if (free(column) >= 0) for_each_entry(column, [&](int, double) { ++entries; });
  result.resizeNonZeros(entries);
  int at = 0;
  for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
    if (free(column) < 0) continue;
    result.outerIndexPtr()[free(column)] = at;
    for_each_entry(column, [&](int row, double value) {
      result.innerIndexPtr()[at] = row;
      result.valuePtr()[at++] = value;
    });
  }
  result.outerIndexPtr()[result.cols()] = at;
  return result;
}

}  // namespace trajan
