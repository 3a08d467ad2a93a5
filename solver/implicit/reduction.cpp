#include "solver/implicit/reduction.h"

#include <algorithm>
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
/// needs no memory beside the matrix.
SparseMatrix reduced(SparseMatrix&& matrix, const SparseMatrix& expand) {
  const std::vector<int> which = selection(expand);
  SparseMatrix result(expand.cols(), expand.cols());
  if (which.empty()) {
    const SparseMatrix half = matrix * expand;
    result = SparseMatrix(expand.transpose()) * half;
    return result;
  }
  int* outer = matrix.outerIndexPtr();
  int* inner = matrix.innerIndexPtr();
  double* value = matrix.valuePtr();
  int at = 0, columns = 0;
  for (int column = 0, begin = 0; column < matrix.cols(); ++column) {
    const int end = outer[column + 1];
    for (int e = begin; e < end && which[static_cast<std::size_t>(column)] >= 0; ++e) {
      const int row = which[static_cast<std::size_t>(inner[e])];
      if (row < 0) continue;
      inner[at] = row;
      value[at++] = value[e];
    }
    if (which[static_cast<std::size_t>(column)] >= 0) outer[++columns] = at;
    begin = end;
  }
  std::copy_n(outer, columns + 1, result.outerIndexPtr());
  result.data().swap(matrix.data());
  result.data().resize(at);
  return result;
}

}  // namespace trajan
