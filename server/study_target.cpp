#include "server/study_target.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>

#include "server/check_scene.h"
#include "server/errors.h"
#include "server/scene_digest.h"
#include "server/store_jobs.h"
#include "server/study_dials.h"
#include "server/study_plan.h"
#include "server/study_table.h"
#include "solver/accuracy/extrapolation.h"
#include "solver/accuracy/target.h"

namespace trajan {

namespace {

constexpr double usual_budget = 600;
constexpr int most_runs_of_a_method = 8;
constexpr int most_failures_of_a_method = 3;
constexpr std::size_t methods_at_first = 2;

[[noreturn]] void refuse(const std::string& message) {
  throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "TARGET", message);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

double budget_of(const v1::Target& target) {
  return target.has_budget_core_seconds() ? target.budget_core_seconds() : usual_budget;
}

void require_sense(const v1::Scene& scene, const v1::Target& target) {
  std::string names;
  for (const v1::Measure& measure : scene.measures()) {
    if (measure.name() == target.measure()) names = measure.name();
  }
  if (names.empty()) {
    for (const v1::Measure& measure : scene.measures()) names += (names.empty() ? "" : ", ") + measure.name();
    refuse("the scene has no measure \"" + target.measure() + "\"; it has: " + (names.empty() ? "none" : names));
  }
  const auto& measure = *std::ranges::find(scene.measures(), target.measure(), &v1::Measure::name);
  const auto exact = measure.exact() == "0" ? std::optional(0.0) : std::nullopt;
  if (accuracy::is_check(measure.quantity(), exact, measure.has_deviation()))
    refuse("measure \"" + names + "\" is a check, whose error smaller cells need not take away");
  const double tolerance = target.has_relative() ? target.relative() : target.absolute();
  if (!std::isfinite(tolerance) || tolerance <= 0) refuse("a target needs a tolerance > 0");
  if (!std::isfinite(budget_of(target)) || budget_of(target) <= 0) refuse("the budget must be > 0 core-seconds");
}

/// Whether a method solves for equilibria or modes: where bodies cut cells in halves, its errors stay as smooth as
/// the tangents, while explicit steps of nodes that are half as heavy do not.
bool is_implicit(v1::Scene scene, const v1::Setting& method) {
  change_scene(scene, method);
  const auto kind = scene.analysis().kind_case();
  return kind != v1::Analysis::KIND_NOT_SET && kind != v1::Analysis::kExplicitDynamics &&
         kind != v1::Analysis::kRelaxation;
}

/// A run of a method; none if such cells make no valid scene.
std::optional<store::PlannedRun> plan_rung(const v1::Scene& scene, const v1::Setting& method, double cell_size) {
  store::PlannedRun planned{{}, scene};
  planned.run.add_settings(method.name());
  if (!change_scene(planned.scene, method).empty()) return std::nullopt;
  const v1::Setting cells = with_cell_size(planned.scene, cell_size);
  planned.run.add_settings(cells.name());
  if (!change_scene(planned.scene, cells).empty() || !violations_of(planned.scene).empty()) return std::nullopt;
  return planned;
}

std::optional<store::PlannedRun> plan_coarsest(const v1::Scene& scene, const v1::Setting& method) {
  for (const double factor : {4, 2, 1}) {
    const double size = accuracy::aligned(factor * scene.domain().cell_size(), common_length(scene));
    if (auto planned = plan_rung(scene, method, size)) return planned;
  }
  return std::nullopt;
}

/// Settings without what changes with the cells.
std::string bytes_of_method(v1::Settings settings) {
  settings.clear_cell_size();
  settings.mutable_numerics()->clear_time_step();
  if (settings.analysis().has_implicit_dynamics())
    settings.mutable_analysis()->mutable_implicit_dynamics()->clear_time_steps();
  return deterministic_bytes(settings);
}

/// Core-seconds of the cheapest run of a method that is known to have been within the tolerance; infinite if none
/// is.
double known_cost(const v1::Settings& method, const v1::Target& target, const std::vector<v1::Finding>& findings) {
  double least = INFINITY;
  for (const v1::Finding& finding : findings) {
    const double tolerance =
        target.has_relative() ? target.relative() : target.absolute() / std::abs(finding.value());
    const bool within = (finding.has_band() && finding.band() <= tolerance) ||
                        (finding.has_error() && finding.error() <= tolerance);
    if (within && finding.measure() == target.measure() &&
        bytes_of_method(finding.settings()) == bytes_of_method(method))
      least = std::min(least, finding.cost().core_seconds());
  }
  return least;
}

/// A method with what its runs gave.
struct Method {
  v1::Setting setting;
  std::vector<accuracy::Rung> rungs;  ///< runs that succeeded, the coarsest first
  std::vector<int> numbers;           ///< theirs in Study.runs
  double smallest = INFINITY;         ///< cell size that was tried
  int tried = 0;
  int failed = 0;
  std::optional<accuracy::Outlook> outlook;
  std::optional<store::PlannedRun> next;

  double value() const { return rungs.back().value; }
  bool has_band() const { return outlook && outlook->band; }
};

bool contradict(const Method& one, const Method& other) {
  return one.has_band() && other.has_band() &&
         std::abs(one.value() - other.value()) > *one.outlook->band + *other.outlook->band;
}

/// A study as its methods' ladders.
class Climb {
 public:
  Climb(const v1::Scene& scene, const v1::Study& study)
      : scene_(scene), target_(study.target()), runs_(study.runs_size()) {
    const std::vector<v1::Setting> known = target_methods(scene);
    for (const std::string& name : study.methods()) {
      const auto setting = std::ranges::find(known, name, &v1::Setting::name);
      if (setting != known.end()) methods_.push_back(read(*setting, study));
    }
    for (const v1::Run& run : study.runs()) {
      all_ += run.cost().core_seconds();
      if (run.answered_by().empty()) spent_ += run.cost().core_seconds();
    }
    for (Method& method : methods_) look_out(method);
    for (Method& method : methods_) method.next = plan_next(method);
  }

  /// Core-seconds of the runs that were computed for this target.
  double spent() const { return spent_; }

  /// The method of the study's last run.
  const Method* last() const {
    const auto found = std::ranges::find_if(methods_, [&](const Method& method) {
      return !method.numbers.empty() && method.numbers.back() + 1 == runs_;
    });
    return found == methods_.end() ? nullptr : &*found;
  }

  /// The method whose answer is within the tolerance and believed; null if there is none yet.
  const Method* reached() const {
    const Method* best = nullptr;
    for (const Method& method : methods_) {
      if (!is_within(method) || !is_believed(method)) continue;
      if (best == nullptr || *method.outlook->band < *best->outlook->band) best = &method;
    }
    return best;
  }

  /// The method whose answer has the narrowest band, or, if none has any, the finest grid.
  const Method* best() const {
    const Method* best = nullptr;
    for (const Method& method : methods_) {
      if (method.rungs.empty()) continue;
      const auto rank = [](const Method& one) { return one.has_band() ? *one.outlook->band : INFINITY; };
      if (best == nullptr || rank(method) < rank(*best)) best = &method;
    }
    return best;
  }

  /// The method that runs next; null if none can.
  const Method* next() const {
    std::size_t begun = 0;
    for (const Method& method : methods_) {
      if (method.next && method.rungs.size() < 2) return &method;
      if (method.rungs.size() >= 2 && ++begun == methods_at_first) break;
    }
    if (const Method* doubtful = cheaper_of_those_that_contradict()) return doubtful;
    const Method* best = nullptr;
    for (const Method& method : methods_) {
      if (!method.next || !method.outlook || method.rungs.size() < 2) continue;
      if (best == nullptr || method.outlook->cost_to_reach < best->outlook->cost_to_reach) best = &method;
    }
    // Two coarse grids more are cheap beside a run that costs several times what there was.
    constexpr double much = 4;
    if (best != nullptr && best->outlook->cost_to_reach < much * all_) return best;
    const auto other = std::ranges::find_if(
        methods_, [](const Method& method) { return method.next && method.rungs.size() < 2; });
    return other == methods_.end() ? best : &*other;
  }

  double tolerance(double value) const {
    return target_.has_relative() ? target_.relative() * std::abs(value) : target_.absolute();
  }

 private:
  Method read(const v1::Setting& setting, const v1::Study& study) const {
    Method method{setting, {}, {}, INFINITY, 0, 0, {}, {}};
    for (int i = 0; i < study.runs_size(); ++i) {
      const v1::Run& run = study.runs(i);
      if (run.settings(0) != setting.name()) continue;
      const double cell_size = std::strtod(run.settings(1).c_str(), nullptr);
      method.smallest = std::min(method.smallest, cell_size);
      ++method.tried;
      const v1::MeasureValue* measure = find_measure(run, target_.measure());
      if (run.state() != v1::SUCCEEDED || measure == nullptr || !std::isfinite(measure->value())) {
        ++method.failed;
        continue;
      }
      method.rungs.push_back({cell_size, measure->value(), run.cost().core_seconds()});
      method.numbers.push_back(i);
    }
    return method;
  }

  void look_out(Method& method) const {
    // Of a value that is 0 no share is a tolerance.
    if (method.rungs.empty() || !(tolerance(method.value()) > 0)) return;
    accuracy::Aim aim{tolerance(method.value()), common_length(scene_), {}, is_implicit(scene_, method.setting)};
    for (const Method& other : methods_) {
      if (&other == &method || other.rungs.size() < 2) continue;
      aim.elsewhere = accuracy::extrapolated(other.rungs[other.rungs.size() - 2], other.rungs.back());
      break;
    }
    method.outlook = accuracy::outlook(method.rungs, aim);
  }

  std::optional<store::PlannedRun> plan_next(const Method& method) const {
    if (method.tried == 0) return plan_coarsest(scene_, method.setting);
    if (method.tried >= most_runs_of_a_method || method.failed >= most_failures_of_a_method) return std::nullopt;
    const bool has_failed = method.rungs.empty() || method.rungs.back().cell_size > method.smallest;
    const double wanted = has_failed || !method.outlook ? method.smallest / 2 : method.outlook->next_cell_size;
    for (const double size : {wanted, method.smallest / 2, method.smallest / 3}) {
      if (auto planned = plan_rung(scene_, method.setting, size)) return planned;
    }
    return std::nullopt;
  }

  bool is_within(const Method& method) const {
    return method.has_band() && *method.outlook->band <= tolerance(method.value());
  }

  bool is_believed(const Method& method) const {
    const bool is_alone = std::ranges::count_if(methods_, &Method::has_band) < 2;
    return (!is_alone || method.rungs.size() > 2) &&
           std::ranges::none_of(methods_, [&](const Method& other) { return contradict(method, other); });
  }

  /// Null if no answer within the tolerance is contradicted by another.
  const Method* cheaper_of_those_that_contradict() const {
    const Method* cheaper = nullptr;
    for (const Method& one : methods_) {
      for (const Method& other : methods_) {
        if (!contradict(one, other) || !(is_within(one) || is_within(other)) || !one.next) continue;
        if (cheaper == nullptr || one.outlook->cost_of_next < cheaper->outlook->cost_of_next) cheaper = &one;
      }
    }
    return cheaper;
  }

  const v1::Scene& scene_;
  const v1::Target& target_;
  std::vector<Method> methods_;
  const int runs_;
  double spent_ = 0;
  double all_ = 0;  ///< also of those whose answers were there
};

v1::Answer answer_of(const Climb& climb, const Method& method) {
  v1::Answer answer;
  answer.set_run(method.numbers.back());
  answer.set_value(method.value());
  if (method.has_band()) answer.set_band(*method.outlook->band);
  answer.set_core_seconds(climb.spent());
  return answer;
}

/// "tip_deflection is -0.67 +- 0.01 (1.5 %) by implicit, TLMPM linear with cells of 0.2"
std::string describe(const v1::Target& target, const Method& method) {
  std::string text = target.measure() + " is " + number(method.value());
  if (method.has_band()) {
    text += " +- " + number(*method.outlook->band);
    char share[32];
    std::snprintf(share, sizeof share, " (%.2g %%)", 100 * *method.outlook->band / std::abs(method.value()));
    if (method.value() != 0) text += share;
  } else {
    text += ", of which no claim can be made yet,";
  }
  return text + " by " + method.setting.name() + " with cells of " + number(method.rungs.back().cell_size);
}

/// Why a run is not begun; empty if it is.
std::string why_not(const Climb& climb, const Method* next, const v1::Target& target) {
  if (next == nullptr) return "no method that suits the scene goes further";
  const double expected = next->outlook ? next->outlook->cost_of_next : 0;
  if (climb.spent() + expected <= budget_of(target)) return {};
  return "the next run would take about " + number(expected) + " core-seconds after " + number(climb.spent()) +
         ", and the budget is " + number(budget_of(target));
}

}  // namespace

store::StudyPlan plan_target(const v1::SubmitJobRequest& request, const std::vector<v1::Finding>& findings) {
  require_valid(request.scene());
  const v1::Target& target = request.fidelity().target();
  require_sense(request.scene(), target);
  std::vector<std::pair<double, std::string>> methods;
  std::set<std::string> different;
  for (const v1::Setting& method : target_methods(request.scene())) {
    const auto planned = plan_coarsest(request.scene(), method);
    if (!planned || !different.insert(bytes_of_method(settings_of(planned->scene))).second) continue;
    methods.emplace_back(known_cost(settings_of(planned->scene), target, findings), method.name());
  }
  std::ranges::stable_sort(methods, {}, &std::pair<double, std::string>::first);
  store::StudyPlan plan;
  plan.kind = "target";
  plan.study.add_dials("method");
  plan.study.add_dials(cell_size_dial);
  *plan.study.mutable_target() = target;
  for (const auto& [cost, name] : methods) plan.study.add_methods(name);
  return plan;
}

TargetStep next_step(const v1::Scene& scene, const v1::Study& study) {
  const Climb climb(scene, study);
  TargetStep step;
  const Method* reached = climb.reached();
  if (const Method* best = reached != nullptr ? reached : climb.best()) {
    step.answer = answer_of(climb, *best);
    step.answer->set_reached(reached != nullptr);
    step.message = describe(study.target(), *best);
  }
  if (reached != nullptr) return step;
  const Method* next = climb.next();
  const std::string end = why_not(climb, next, study.target());
  if (end.empty()) {
    step.run = next->next;
    const Method* last = climb.last();
    step.message = last == nullptr ? "" : describe(study.target(), *last);
  } else {
    if (step.answer) step.answer->set_end(end);
    step.message += (step.message.empty() ? "" : "; ") + end;
  }
  return step;
}

}  // namespace trajan
