#include "solver/schemes/time_step.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "solver/schemes/schemes.h"

namespace trajan {

double stable_time_step(const Model& model, double wave_speed, double particle_speed) {
  // A wave along the diagonal of a cell sees the stiffness of all axes: sqrt(2) in a plane.
  const double advection = find_scheme(model.numerics.scheme)->total_lagrangian ? 0.0 : particle_speed;
  return model.grid.cell / (std::sqrt(static_cast<double>(grid_axes(model.dimension))) * wave_speed + advection);
}

TimeStepLimit time_step_limit(const Model& model) {
  TimeStepLimit limit{std::numeric_limits<double>::infinity(), ""};
  for (const Material& material : model.materials) {
    const double speed = material.kind->wave_speed(material.parameters, material.density, model.dimension);
    const double step = stable_time_step(model, speed, 0);
    if (step >= limit.value) continue;
    std::ostringstream because;
    because << "wave speed " << speed << " of material " << material.name;
    limit = {step, because.str()};
  }
  return limit;
}

}  // namespace trajan
