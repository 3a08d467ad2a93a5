// Compiled once for each instruction set and number type, with TRAJAN_INSTRUCTION_SET the name of both.
#include "solver/schemes/kernels.h"
#include "solver/shapes/transfers.h"
#include "solver/transfers/law_exchange.h"
#include "solver/transfers/node_updates.h"
#include "solver/transfers/pointwise.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {
namespace {

const TransferKernels* transfer(std::string_view name, Dimension dimension, Margin margin) {
#define TRAJAN_CHOOSE(Shape, transfer_of) \
  if (name == (Shape)) return transfer_of(dimension, margin);
  TRAJAN_FOR_EACH_SHAPE(TRAJAN_CHOOSE)
#undef TRAJAN_CHOOSE
  return nullptr;
}

template <int D>
constexpr MotionKernels motion{
    &find_loads<D>,         &kick<D>,    &kick_and_blend<D>,   &move<D>,          &displace<D>,
    &measure_motion<D>,     &account<D>, &calm_light_nodes<D>, &take_velocity<D>, &own_velocity<D>,
    law_exchange<Real, D>()};

}  // namespace

extern const GridKernels compiled_grid_kernels;
const GridKernels compiled_grid_kernels{{motion<1>, motion<2>, motion<3>}, &transfer};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
