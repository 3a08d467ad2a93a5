#include "solver/analyses/run.h"

#include <chrono>

#include "solver/simulation/diverged.h"
#include "solver/simulation/simulation.h"

namespace trajan {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

/// How often a stop request is asked, seconds; half of what is promised.
constexpr double asking_interval = 0.05;

class Run {
 public:
  Run(const Model& model, const RunOptions& options, Recorder& recorder, const StopRequest& stop)
      : model_(model),
        options_(options),
        recorder_(recorder),
        stop_(stop),
        simulation_(options.resume ? Simulation(model, options.threads, *options.resume)
                                   : Simulation(model, options.threads)) {}

  RunResult go() {
    if (!options_.resume) record();
    last_checkpoint_ = last_asked_ = Clock::now();
    first_step_ = simulation_.steps();
    RunResult result;
    try {
      result.end = loop();
    } catch (const Diverged& diverged) {
      result.end = RunEnd::diverged;
      result.divergence = diverged.divergence();
    }
    result.progress = progress();
    result.warnings = std::move(warnings_);
    return result;
  }

 private:
  RunEnd loop() {
    while (simulation_.sample() < model_.outputs.samples) {
      if (simulation_.step()) {
        record();
        checkpoint_if_due();
      }
      if (asked_to_stop()) return RunEnd::stopped;
    }
    return RunEnd::finished;
  }

  void record() {
    const std::int64_t row = simulation_.sample();
    recorder_.sample(row, simulation_.time(), simulation_.columns());
    const std::int64_t every = model_.outputs.samples_per_snapshot;
    if (every > 0 && row % every == 0) recorder_.snapshot(row, simulation_.snapshot());
    for (const Warning& warning : simulation_.warnings()) warn(warning);
  }

  void warn(const Warning& warning) {
    if (warnings_.size() == most_warnings) return;
    warnings_.push_back(warning);
    if (warnings_.size() == most_warnings) {
      warnings_.back().name = "more";
      warnings_.back().cause = "there is more to warn of than is kept";
    }
    recorder_.warn(warnings_.back());
  }

  void checkpoint_if_due() {
    const bool always = options_.checkpoint_interval <= 0;
    if (simulation_.sample() == model_.outputs.samples) return;
    if (!always && seconds(last_checkpoint_, Clock::now()) < options_.checkpoint_interval) return;
    recorder_.checkpoint(simulation_.save());
    last_checkpoint_ = Clock::now();
  }

  bool asked_to_stop() {
    const Clock::time_point now = Clock::now();
    const double since = seconds(last_asked_, now);
    if (since < asking_interval) return false;
    speed_ = static_cast<double>((simulation_.steps() - first_step_) * model_.particle_count()) / since;
    first_step_ = simulation_.steps();
    last_asked_ = now;
    return stop_ && stop_(progress());
  }

  RunProgress progress() const {
    RunProgress progress;
    progress.step = simulation_.steps();
    progress.total_steps = simulation_.steps() + simulation_.steps_left();
    progress.time = simulation_.time();
    progress.end_time = model_.end_time;
    progress.rows = recorder_.durable_rows();
    progress.energy_balance_error = simulation_.energy_balance_error();
    progress.particle_steps_per_second = speed_;
    return progress;
  }

  const Model& model_;
  const RunOptions& options_;
  Recorder& recorder_;
  const StopRequest& stop_;
  Simulation simulation_;
  Clock::time_point last_checkpoint_, last_asked_;
  std::int64_t first_step_ = 0;
  double speed_ = 0;
  std::vector<Warning> warnings_;
};

}  // namespace

RunResult run(const Model& model, const RunOptions& options, Recorder& recorder, const StopRequest& stop) {
  return Run(model, options, recorder, stop).go();
}

}  // namespace trajan
