// Compiled once for each instruction set that is dispatched to, with TRAJAN_INSTRUCTION_SET its name.
#include "solver/schemes/kernels.h"

#include "solver/materials/law_names.h"
#include "solver/shapes/transfers.h"
#include "solver/transfers/node_updates.h"
#include "solver/transfers/pointwise.h"

#define TRAJAN_TEXT_OF(name) #name
#define TRAJAN_TEXT(name) TRAJAN_TEXT_OF(name)

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

// One translation unit for each law.
#define TRAJAN_DECLARE(law) const LawKernels* kernels_of_##law(Dimension, bool total_lagrangian);
TRAJAN_FOR_EACH_LAW_NAME(TRAJAN_DECLARE)
#undef TRAJAN_DECLARE

namespace {

const LawKernels* law(std::string_view name, Dimension dimension, bool total_lagrangian) {
#define TRAJAN_CHOOSE(law) \
  if (name == #law) return kernels_of_##law(dimension, total_lagrangian);
  TRAJAN_FOR_EACH_LAW_NAME(TRAJAN_CHOOSE)
#undef TRAJAN_CHOOSE
  return nullptr;
}

const TransferKernels* transfer(std::string_view name, Dimension dimension) {
#define TRAJAN_CHOOSE(Shape, transfer_of) \
  if (name == Shape) return transfer_of(dimension);
  TRAJAN_FOR_EACH_SHAPE(TRAJAN_CHOOSE)
#undef TRAJAN_CHOOSE
  return nullptr;
}

template <int D>
constexpr MotionKernels motion{&find_loads<D>,   &kick<D>,           &kick_and_blend<D>, &move<D>,
                               &displace<D>,     &measure_motion<D>, &account<D>,        &calm_light_nodes<D>,
                               &take_velocity<D>};

}  // namespace

extern const Kernels compiled_kernels;
const Kernels compiled_kernels{
    TRAJAN_TEXT(TRAJAN_INSTRUCTION_SET), {motion<1>, motion<2>, motion<3>}, &transfer, &law};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
