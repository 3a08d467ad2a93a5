#include "solver/schemes/time_step.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace trajan {

TimeStepLimit time_step_limit(const Model& model) {
  TimeStepLimit limit{std::numeric_limits<double>::infinity(), ""};
  for (const Material& material : model.materials) {
    const double speed = material.kind->wave_speed(material.parameters, material.density, model.dimension);
    // A wave along the diagonal of a square cell sees the stiffness of both axes: sqrt(2).
    const double step = model.grid.cell / (std::sqrt(2.0) * speed);
    if (step < limit.value) {
      std::ostringstream because;
      because << "wave speed " << speed << " of material " << material.name;
      limit = {step, because.str()};
    }
  }
  return limit;
}

}  // namespace trajan
