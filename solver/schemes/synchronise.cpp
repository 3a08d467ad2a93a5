#include "solver/schemes/schemes.h"
#include "solver/simulation/executor.h"

namespace trajan {

void synchronise(Executor& mpm, const StepTimes& times) {
  mpm.particles({Pass::locate, Pass::force, Pass::scatter_state});
  mpm.update_velocities(times);
  mpm.particles({Pass::locate, Pass::kick});
  mpm.finish();
}

}  // namespace trajan
