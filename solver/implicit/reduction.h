#pragma once

#include "solver/implicit/assembly.h"

namespace trajan {

/// What is left of a matrix of all unknowns for those that are free: expand^T matrix expand. Takes its memory.
SparseMatrix reduced(SparseMatrix&& matrix, const SparseMatrix& expand);

}  // namespace trajan
