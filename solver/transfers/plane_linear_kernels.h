#pragma once

#include "solver/transfers/plane_linear_gather.h"
#include "solver/transfers/plane_linear_scatter.h"
#include "solver/transfers/transfer_kernels.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

inline constexpr TransferKernels plane_linear_kernels{plane_linear_layout,
                                                      PlaneLinearValue::copies,
                                                      0,
                                                      false,
                                                      false,
                                                      &locate_in_cells,
                                                      &scatter_state_plane_linear,
                                                      nullptr,
                                                      &scatter_loads_plane_linear,
                                                      &scatter_mass_plane_linear,
                                                      &scatter_momentum_plane_linear,
                                                      &gather_acceleration_plane_linear,
                                                      &gather_velocity_plane_linear,
                                                      &gather_gradient_plane_linear,
                                                      &gather_motion_plane_linear,
                                                      nullptr,
                                                      &update_velocities<plane_linear_layout>,
                                                      &map_velocities<plane_linear_layout>,
                                                      &load_window_plane_linear,
                                                      {},
                                                      nullptr,
                                                      nullptr,
                                                      nullptr,
                                                      &transfer_kernels<Linear, plane_linear_layout>};

template <>
struct TransferChoice<Linear> {
  static const TransferKernels* of(Dimension dimension) {
    switch (dimension) {
      case Dimension::bar:
        return &transfer_kernels<Linear, Layout{1, false}>;
      case Dimension::axisymmetric:
        return &transfer_kernels<Linear, Layout{2, false}>;
      case Dimension::solid:
        return &transfer_kernels<Linear, Layout{3, false}>;
      default:
        return &plane_linear_kernels;
    }
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
