#include "tests/verification/gallery.h"

#include <google/protobuf/text_format.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "server/convert.h"
#include "solver/analyses/run.h"
#include "solver/measures/measure.h"
#include "solver/model/validate.h"

namespace trajan::verification {

namespace {

const std::filesystem::path scenes = TRAJAN_SCENES;

/// Keeps histories in memory, and shows snapshots.
class MemoryRecorder : public Recorder {
 public:
  MemoryRecorder(std::vector<double>& time, std::vector<double>& values, const SnapshotObserver& observe)
      : time_(time), values_(values), observe_(observe) {}
  void sample(std::int64_t, double time, std::span<const double> columns) override {
    time_.push_back(time);
    values_.insert(values_.end(), columns.begin(), columns.end());
  }
  void snapshot(std::int64_t, const Snapshot& snapshot) override { observe_(snapshot); }
  void checkpoint(const Checkpoint&) override {}
  std::int64_t durable_rows() const override { return static_cast<std::int64_t>(time_.size()); }

 private:
  std::vector<double>& time_;
  std::vector<double>& values_;
  const SnapshotObserver& observe_;
};

}  // namespace

std::vector<std::string> gallery_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
    if (entry.path().extension() == ".textproto") names.push_back(entry.path().stem());
  }
  std::ranges::sort(names);
  return names;
}

std::filesystem::path gallery_file(std::string_view name) { return scenes / (std::string(name) + ".textproto"); }

Scene gallery_scene(std::string_view name) {
  const std::filesystem::path path = gallery_file(name);
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  v1::Scene message;
  if (!file || !google::protobuf::TextFormat::ParseFromString(text.str(), &message)) {
    throw std::runtime_error("cannot read " + path.string());
  }
  return to_scene(message);
}

std::vector<double> Outcome::history(std::string_view column) const {
  const auto found = std::ranges::find(columns, column);
  if (found == columns.end()) throw std::out_of_range("no column " + std::string(column));
  std::vector<double> result;
  for (std::size_t i = found - columns.begin(); i < values.size(); i += columns.size())
    result.push_back(values[i]);
  return result;
}

const MeasureValue& Outcome::measure(std::string_view name) const {
  const auto found = std::ranges::find(measures, name, &MeasureValue::name);
  if (found == measures.end()) throw std::out_of_range("no measure " + std::string(name));
  return *found;
}

Outcome run_scene(const Scene& scene, const SnapshotObserver& observe) {
  const Model model = validate(scene);
  Outcome outcome;
  outcome.particles = model.particle_count();
  outcome.columns = history_columns(model);
  MemoryRecorder recorder(outcome.time, outcome.values, observe);
  const std::clock_t start = std::clock();
  const RunResult result = run(model, {}, recorder, [](const RunProgress&) { return false; });
  outcome.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  outcome.steps = result.progress.step;
  if (result.divergence) {
    const Divergence& divergence = *result.divergence;
    throw std::runtime_error(scene.name + " diverged at time " + std::to_string(divergence.time) + ", particle " +
                             std::to_string(divergence.particle) + ": " + divergence.cause);
  }
  outcome.warnings = result.warnings;
  outcome.measures = evaluate(model, outcome.time, outcome.values);
  return outcome;
}

}  // namespace trajan::verification
