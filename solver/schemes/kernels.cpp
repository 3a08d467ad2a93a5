// Compiled once for each instruction set that is dispatched to, with TRAJAN_INSTRUCTION_SET its name.
#include "solver/schemes/kernels.h"

#include "solver/materials/law_names.h"

#define TRAJAN_TEXT_OF(name) #name
#define TRAJAN_TEXT(name) TRAJAN_TEXT_OF(name)
#define TRAJAN_FLOAT_OF(name) name##_float
#define TRAJAN_FLOAT(name) TRAJAN_FLOAT_OF(name)

namespace trajan {

namespace TRAJAN_FLOAT(TRAJAN_INSTRUCTION_SET) {
  extern const GridKernels compiled_grid_kernels;
}

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

}  // namespace

extern const GridKernels compiled_grid_kernels;
extern const Kernels compiled_kernels;
const Kernels compiled_kernels{TRAJAN_TEXT(TRAJAN_INSTRUCTION_SET), compiled_grid_kernels,
                               TRAJAN_FLOAT(TRAJAN_INSTRUCTION_SET)::compiled_grid_kernels, &law};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
