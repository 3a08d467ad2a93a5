#pragma once

#include <string_view>

#include "solver/transfers/corner_stencil.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Convected particle domains: parallelepipeds that deform with their particle, piecewise linear functions
/// interpolated between their corners (Sadeghirad, Brannon and Burghardt 2011).
struct Cpdi {
  static constexpr std::string_view name = "cpdi";
  static constexpr int nodes = 4;
  static constexpr bool wide = true;
  static constexpr bool needs_deformation = true;
  static int first_node(double at) { return static_cast<int>(at) - 1; }
};

template <>
struct TransferChoice<Cpdi> {
  static const TransferKernels* of(Dimension dimension) { return corner_kernels<Cpdi>(grid_axes(dimension)); }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
