#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/validator.h"
#include "solver/schemes/scheme.h"
#include "solver/schemes/time_step.h"
#include "solver/transfers/transfer.h"

namespace trajan {

namespace {

/// A run of more steps would not end within anybody's patience.
constexpr double most_steps = 1e12;

std::vector<std::string> strings(std::span<const std::string_view> names) { return {names.begin(), names.end()}; }

}  // namespace

void Validator::check_numerics() {
  const Numerics& numerics = scene_.numerics;
  const auto schemes = strings(scheme_names());
  const auto shapes = strings(shape_names());
  if (std::ranges::find(schemes, numerics.scheme) == schemes.end()) {
    unknown_name("numerics.scheme", numerics.scheme, "scheme", schemes);
  }
  if (std::ranges::find(shapes, numerics.shape_functions) == shapes.end()) {
    unknown_name("numerics.shape_functions", numerics.shape_functions, "shape function", shapes);
  }
  check_transfer();
  const std::vector<std::string> remedies = {"none", "mean_dilatation"};
  if (std::ranges::find(remedies, numerics.locking_remedy) == remedies.end())
    unknown_name("numerics.locking_remedy", numerics.locking_remedy, "locking remedy", remedies);
  const std::vector<std::string> precisions = {"DOUBLE", std::string(float_precision)};
  if (std::ranges::find(precisions, numerics.precision) == precisions.end())
    unknown_name("numerics.precision", numerics.precision, "precision", precisions);
  if (!(numerics.time_step_fraction > 0 && numerics.time_step_fraction <= 1)) {
    violations_.add("numerics.time_step_fraction", number_text(numerics.time_step_fraction), "out of range",
                    "give a value greater than 0 and at most 1");
  }
  if (numerics.time_step) violations_.positive("numerics.time_step", *numerics.time_step);
  if (numerics.threads) violations_.within("numerics.threads", *numerics.threads, 1, 256);
  model_.numerics = numerics;
}

void Validator::check_transfer() {
  const Numerics& numerics = scene_.numerics;
  if (numerics.flip_fraction) violations_.within("numerics.flip_fraction", *numerics.flip_fraction, 0, 1);
  if (numerics.transfer_order) violations_.within("numerics.transfer_order", *numerics.transfer_order, 1, 20);
  const Transfer* transfer = find_transfer(numerics.transfer);
  if (!transfer) {
    unknown_name("numerics.transfer", numerics.transfer, "transfer", strings(transfer_names()));
    return;
  }
  const std::string_view objection = transfer->objection(numerics);
  if (!objection.empty())
    violations_.add("numerics.transfer", numerics.transfer, std::string(objection), "choose another transfer");
}

void Validator::check_time_step() {
  const AnalysisKind& kind = model_.analysis;
  if (!std::holds_alternative<ExplicitDynamics>(kind) && !std::holds_alternative<Relaxation>(kind)) return;
  const TimeStepLimit limit = time_step_limit(model_);
  const auto& asked = model_.numerics.time_step;
  if (asked && !(*asked <= limit.value)) {
    violations_.add("numerics.time_step", number_text(*asked), "beyond the stable limit",
                    "give at most " + number_text(limit.value) + " (" + limit.because + ") or leave it out");
    return;
  }
  const double step = asked ? *asked : limit.value * model_.numerics.time_step_fraction;
  if (!(model_.end_time / step <= most_steps)) {
    violations_.add("analysis.end_time", number_text(model_.end_time),
                    "this takes " + number_text(model_.end_time / step) + " steps of " + number_text(step),
                    "the step is limited by " + limit.because +
                        ": give an earlier end, larger cells or a slower material: at most 10^12 steps");
  }
}

}  // namespace trajan
