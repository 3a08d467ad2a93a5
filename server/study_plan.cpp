#include "server/study_plan.h"

#include <algorithm>
#include <map>
#include <set>

#include "proto/field_change.h"
#include "server/check_scene.h"
#include "server/errors.h"
#include "server/study_dials.h"

namespace trajan {

namespace {

constexpr std::size_t most_runs = 1000;
constexpr std::size_t most_bytes = std::size_t{256} << 20;

using Dials = google::protobuf::RepeatedPtrField<v1::Dial>;

[[noreturn]] void refuse(const std::string& reason, const std::string& message) {
  throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, reason, message);
}

void require_settings(const v1::Dial& dial) {
  std::set<std::string> names;
  for (const v1::Setting& setting : dial.settings()) {
    if (!names.insert(setting.name()).second)
      refuse("DIALS", "dial \"" + dial.name() + "\" has the setting \"" + setting.name() + "\" twice");
  }
  if (names.empty()) refuse("DIALS", "dial \"" + dial.name() + "\" has no settings");
}

/// Returns how many combinations there are.
std::size_t require_dials(const v1::Scene& scene, const Dials& dials) {
  std::set<std::string> names;
  std::size_t combinations = 1;
  if (dials.empty()) refuse("DIALS", "a study needs at least one dial");
  for (const v1::Dial& dial : dials) {
    if (!names.insert(dial.name()).second) refuse("DIALS", "there are two dials \"" + dial.name() + "\"");
    require_settings(dial);
    combinations *= static_cast<std::size_t>(dial.settings_size());
    if (combinations > most_runs)
      refuse("TOO_MANY_RUNS", "a study has at most " + std::to_string(most_runs) + " runs");
  }
  if (combinations * scene.ByteSizeLong() > most_bytes)
    refuse("TOO_MANY_BYTES", "the scenes of a study have at most 256 MiB together");
  return combinations;
}

/// The combination with this number: one setting of each dial, those of the last dial varying fastest.
std::vector<const v1::Setting*> combination(const Dials& dials, std::size_t number) {
  std::vector<const v1::Setting*> settings(static_cast<std::size_t>(dials.size()));
  for (int dial = dials.size() - 1; dial >= 0; --dial) {
    const auto count = static_cast<std::size_t>(dials[dial].settings_size());
    settings[static_cast<std::size_t>(dial)] = &dials[dial].settings(static_cast<int>(number % count));
    number /= count;
  }
  return settings;
}

/// "domain.cell_size=0.1, numerics.scheme=USL"
std::string describe(const Dials& dials, const v1::Run& run) {
  std::string text;
  for (int dial = 0; dial < dials.size(); ++dial)
    text += (dial == 0 ? "" : ", ") + dials[dial].name() + "=" + run.settings(dial);
  return text;
}

/// Violations of many scenes, each once with the runs that have it.
class Violations {
 public:
  void add(const v1::Violation& violation, const std::string& run) {
    auto& entry = entries_[violation.SerializeAsString()];
    entry.first = violation;
    entry.second.push_back(run);
  }

  bool empty() const { return entries_.empty(); }

  /// The details travel in the trailing metadata, which gRPC limits to 8 KiB: as many as there is room for.
  [[noreturn]] void fail(std::size_t runs) const {
    constexpr std::size_t room = 6000;
    ServiceError error(grpc::StatusCode::INVALID_ARGUMENT, "INVALID_SCENE",
                       std::to_string(entries_.size()) + " violations in the study's scenes");
    for (const auto& [bytes, entry] : entries_) {
      v1::Violation violation = entry.first;
      if (entry.second.size() < runs) violation.set_run(some(entry.second));
      if (error.details().ByteSizeLong() + violation.ByteSizeLong() > room) break;
      *error.details().add_violations() = violation;
    }
    throw error;
  }

 private:
  static std::string some(const std::vector<std::string>& runs) {
    constexpr std::size_t most = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, runs.size()); ++i) text += (i == 0 ? "" : "; ") + runs[i];
    return runs.size() <= most ? text : text + " and " + std::to_string(runs.size() - most) + " more";
  }

  std::map<std::string, std::pair<v1::Violation, std::vector<std::string>>> entries_;
};

/// A run of a combination, and what is wrong with it.
google::protobuf::RepeatedPtrField<v1::Violation> plan_run(const std::vector<const v1::Setting*>& settings,
                                                           store::PlannedRun& planned) {
  google::protobuf::RepeatedPtrField<v1::Violation> violations;
  for (const v1::Setting* setting : settings) {
    planned.run.add_settings(setting->name());
    violations.MergeFrom(change_scene(planned.scene, *setting));
  }
  return violations.empty() ? violations_of(planned.scene) : violations;
}

/// Every combination must be valid.
store::StudyPlan plan_all(const std::string& kind, const v1::Scene& scene, const Dials& dials) {
  store::StudyPlan plan;
  plan.kind = kind;
  const std::size_t combinations = require_dials(scene, dials);
  for (const v1::Dial& dial : dials) plan.study.add_dials(dial.name());
  Violations violations;
  for (std::size_t number = 0; number < combinations; ++number) {
    store::PlannedRun& planned = plan.runs.emplace_back(store::PlannedRun{{}, scene});
    for (const v1::Violation& violation : plan_run(combination(dials, number), planned))
      violations.add(violation, describe(dials, planned.run));
  }
  if (!violations.empty()) violations.fail(combinations);
  return plan;
}

store::StudyPlan plan_ladder(const v1::Scene& scene, const v1::Ladder& ladder) {
  // What is wrong with the scene itself is said of it, not of its levels.
  require_valid(scene);
  Dials dials;
  *dials.Add() = ladder_dial(scene, ladder);
  return plan_all("ladder", scene, dials);
}

/// The one that is asked for, or the first whose exact value is not 0, or the first.
const v1::Measure& measure_of(const v1::SubmitStudyRequest& request) {
  const auto& measures = request.scene().measures();
  const std::string& asked = request.tradeoff().measure();
  const auto found = std::ranges::find_if(measures, [&](const v1::Measure& measure) {
    return asked.empty() ? !measure.exact().empty() && measure.exact() != "0" : measure.name() == asked;
  });
  if (found != measures.end()) return *found;
  if (!asked.empty()) refuse("MEASURE", "the scene has no measure \"" + asked + "\"");
  if (measures.empty()) refuse("MEASURE", "the scene has no measures: there is nothing to be accurate about");
  return measures[0];
}

/// What is not valid is left out and counted.
store::StudyPlan plan_tradeoff(const v1::SubmitStudyRequest& request) {
  require_valid(request.scene());
  const v1::Measure& measure = measure_of(request);
  const Dials dials =
      request.tradeoff().dials().empty() ? default_dials(request.scene()) : request.tradeoff().dials();
  const std::size_t combinations = require_dials(request.scene(), dials);
  store::StudyPlan plan;
  plan.kind = "tradeoff";
  for (const v1::Dial& dial : dials) plan.study.add_dials(dial.name());
  std::map<std::string, int> left_out;
  for (std::size_t number = 0; number < combinations; ++number) {
    store::PlannedRun planned{{}, request.scene()};
    const auto violations = plan_run(combination(dials, number), planned);
    if (violations.empty()) plan.runs.push_back(std::move(planned));
    if (!violations.empty()) ++left_out[violations[0].path() + ": " + violations[0].problem()];
  }
  v1::Trade& trade = *plan.study.mutable_trade();
  trade.set_measure(measure.name());
  trade.set_reference_source(measure.exact().empty() ? "extrapolated" : "exact");
  for (const auto& [reason, count] : left_out) {
    v1::Skipped& skipped = *trade.add_skipped();
    skipped.set_reason(reason);
    skipped.set_combinations(count);
  }
  if (plan.runs.empty()) refuse("DIALS", "no combination of settings is valid: " + left_out.begin()->first);
  return plan;
}

}  // namespace

google::protobuf::RepeatedPtrField<v1::Violation> change_scene(v1::Scene& scene, const v1::Setting& setting) {
  google::protobuf::RepeatedPtrField<v1::Violation> violations;
  for (const std::string& text : setting.changes()) {
    try {
      change_field(scene, text);
    } catch (const FieldChangeError& error) {
      v1::Violation& violation = *violations.Add();
      violation.set_path(text.substr(0, text.find('=')));
      violation.set_value(text);
      violation.set_problem(error.what());
      violation.set_remedy(error.hint);
    }
  }
  return violations;
}

store::StudyPlan plan_study(const v1::SubmitStudyRequest& request) {
  switch (request.kind_case()) {
    case v1::SubmitStudyRequest::kSweep:
      return plan_all("sweep", request.scene(), request.sweep().dials());
    case v1::SubmitStudyRequest::kLadder:
      return plan_ladder(request.scene(), request.ladder());
    case v1::SubmitStudyRequest::kTradeoff:
      return plan_tradeoff(request);
    case v1::SubmitStudyRequest::KIND_NOT_SET:
      break;
  }
  refuse("KIND", "say what kind of study it is: a sweep, a ladder or a tradeoff");
}

}  // namespace trajan
