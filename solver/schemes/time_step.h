#pragma once

#include <string>

#include "solver/model/model.h"

namespace trajan {

struct TimeStepLimit {
  double value = 0;     ///< the largest stable step at time 0, time units
  std::string because;  ///< for people, for example "wave speed 57.7 of material steel"
};

/// The largest stable step while the fastest wave has this speed (of the reference configuration in a
/// total Lagrangian scheme) and the fastest particle that one.
double stable_time_step(const Model& model, double wave_speed, double particle_speed);

/// The stability limit of the model's scheme at time 0, without building the simulation.
TimeStepLimit time_step_limit(const Model& model);

}  // namespace trajan
