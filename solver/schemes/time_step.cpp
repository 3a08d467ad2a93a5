#include "solver/schemes/time_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "solver/schemes/schemes.h"

namespace trajan {
namespace {

double largest_diffusivity(const Model& model) {
  double largest = 0;
  for (const Material& material : model.materials)
    if (material.kind->diffusivity != nullptr)
      largest = std::max(largest, material.kind->diffusivity(material.parameters, material.density));
  return largest;
}

}  // namespace

double stable_time_step(const Model& model, double wave_speed, double particle_speed) {
  // A wave along the diagonal of a cell sees the stiffness of all axes: sqrt(2) in a plane.
  const double axes = grid_axes(model.dimension), cell = model.grid.cell;
  const double advection = find_scheme(model.numerics.scheme)->total_lagrangian ? 0.0 : particle_speed;
  const double by_waves = cell / (std::sqrt(axes) * wave_speed + advection);
  // Diffusion of momentum alone would allow cell^2 / (2 axes diffusivity); the rates of both add up.
  const double diffusivity = largest_diffusivity(model);
  return diffusivity > 0 ? 1 / (1 / by_waves + 2 * axes * diffusivity / (cell * cell)) : by_waves;
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
