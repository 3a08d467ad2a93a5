#include "server/study_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>

#include "solver/accuracy/extrapolation.h"
#include "solver/accuracy/trade.h"

namespace trajan {

namespace {

/// 1 if it is the same in all runs.
double cell_size_of(const v1::Study& study, const v1::Run& run) {
  const auto dial = std::ranges::find(study.dials(), cell_size_dial);
  if (dial == study.dials().end()) return 1;
  return std::strtod(run.settings(static_cast<int>(dial - study.dials().begin())).c_str(), nullptr);
}

v1::Convergence::Behaviour to_proto(accuracy::Behaviour behaviour) {
  switch (behaviour) {
    case accuracy::Behaviour::monotone:
      return v1::Convergence::MONOTONE;
    case accuracy::Behaviour::oscillating:
      return v1::Convergence::OSCILLATING;
    case accuracy::Behaviour::not_converging:
      return v1::Convergence::NOT_CONVERGING;
    case accuracy::Behaviour::constant:
      return v1::Convergence::CONSTANT;
  }
  return v1::Convergence::BEHAVIOUR_UNSPECIFIED;
}

v1::Convergence describe(const std::string& measure, const std::vector<accuracy::Level>& levels) {
  const accuracy::Estimate estimate = accuracy::estimate(levels);
  v1::Convergence convergence;
  convergence.set_measure(measure);
  convergence.set_behaviour(to_proto(estimate.behaviour));
  for (const accuracy::Level& level : levels) {
    convergence.add_cell_sizes(level.cell_size);
    convergence.add_values(level.value);
  }
  if (estimate.order) convergence.set_order(*estimate.order);
  convergence.set_asymptotic(estimate.asymptotic);
  if (estimate.extrapolated) convergence.set_extrapolated(*estimate.extrapolated);
  if (estimate.band) convergence.set_band(*estimate.band);
  convergence.set_no_claim(estimate.no_claim);
  return convergence;
}

bool all_succeeded(const v1::Study& study) {
  return std::ranges::all_of(study.runs(), [](const v1::Run& run) { return run.state() == v1::SUCCEEDED; });
}

/// Of a check no claim is made.
void withdraw(v1::Convergence& convergence) {
  convergence.clear_extrapolated();
  convergence.clear_band();
  convergence.set_no_claim("it is a check, whose exact value is not what smaller cells approach");
}

void derive_ladder(v1::Study& study, const v1::Scene& scene) {
  if (study.runs().empty() || !all_succeeded(study)) return;
  const v1::Run& finest = study.runs(study.runs_size() - 1);
  for (const v1::MeasureValue& measure : finest.measures()) {
    std::vector<accuracy::Level> levels;
    for (const v1::Run& run : study.runs()) {
      const v1::MeasureValue* value = find_measure(run, measure.name());
      if (value != nullptr) levels.push_back({cell_size_of(study, run), value->value()});
    }
    v1::Convergence convergence = describe(measure.name(), levels);
    if (measure.has_exact()) convergence.set_exact(measure.exact());
    if (is_check(scene, measure)) withdraw(convergence);
    *study.add_convergences() = convergence;
  }
}

/// All settings but the cell size.
std::string method_of(const v1::Study& study, const v1::Run& run) {
  std::string method;
  for (int dial = 0; dial < study.dials_size(); ++dial) {
    if (study.dials(dial) != cell_size_dial) method += (method.empty() ? "" : ", ") + run.settings(dial);
  }
  return method;
}

/// The runs of each method that have succeeded, the coarsest grid first.
using Methods = std::map<std::string, std::vector<int>>;

Methods methods_of(const v1::Study& study) {
  Methods methods;
  for (int i = 0; i < study.runs_size(); ++i) {
    const v1::Run& run = study.runs(i);
    if (run.state() == v1::SUCCEEDED && find_measure(run, study.trade().measure()) != nullptr)
      methods[method_of(study, run)].push_back(i);
  }
  for (auto& [name, runs] : methods) {
    std::ranges::sort(runs, std::ranges::greater{}, [&](int i) { return cell_size_of(study, study.runs(i)); });
  }
  return methods;
}

/// The extrapolation with the narrowest band among the ladders that the methods are. None if no method makes a
/// claim.
std::optional<v1::Convergence> narrowest(const v1::Study& study, const Methods& methods) {
  std::optional<v1::Convergence> best;
  for (const auto& [name, runs] : methods) {
    std::vector<accuracy::Level> levels;
    for (const int i : runs) {
      const v1::Run& run = study.runs(i);
      const double value = find_measure(run, study.trade().measure())->value();
      const double size = cell_size_of(study, run);
      if (levels.empty() || size < levels.back().cell_size) levels.push_back({size, value});
    }
    if (levels.size() < 3) continue;
    const v1::Convergence convergence = describe(name, levels);
    if (convergence.has_band() && (!best || convergence.band() < best->band())) best = convergence;
  }
  return best;
}

/// Sets the errors of all runs that have any, against exact values if there are, which may be different in each
/// run.
void set_errors(v1::Study& study, const Methods& methods) {
  v1::Trade& trade = *study.mutable_trade();
  std::optional<v1::Convergence> extrapolation;
  if (trade.reference_source() == "extrapolated") {
    extrapolation = narrowest(study, methods);
    if (!extrapolation) return;
    trade.set_reference(extrapolation->extrapolated());
    trade.set_reference_band(extrapolation->band());
  }
  for (const auto& [name, runs] : methods) {
    for (const int i : runs) {
      v1::Run& run = *study.mutable_runs(i);
      const v1::MeasureValue& measure = *find_measure(run, trade.measure());
      if (measure.has_error() && !extrapolation) {
        run.set_error(std::abs(measure.error()));
        trade.set_reference(measure.exact());
      } else if (extrapolation) {
        const double scale = trade.reference() == 0 ? 1 : std::abs(trade.reference());
        run.set_error(std::abs(measure.value() - trade.reference()) / scale);
      }
    }
  }
}

void derive_trade(v1::Study& study) {
  const Methods methods = methods_of(study);
  set_errors(study, methods);
  std::vector<accuracy::Point> points;
  std::vector<int> numbers;
  std::size_t method = 0;
  for (const auto& [name, runs] : methods) {
    for (const int i : runs) {
      const v1::Run& run = study.runs(i);
      if (!run.has_error()) continue;
      points.push_back({run.cost().core_seconds(), run.error(), method, cell_size_of(study, run)});
      numbers.push_back(i);
    }
    ++method;
  }
  const std::vector<bool> pareto = accuracy::pareto_set(points);
  for (std::size_t i = 0; i < points.size(); ++i) study.mutable_runs(numbers[i])->set_pareto(pareto[i]);
  for (const double tolerance : {0.1, 0.03, 0.01, 0.003, 0.001}) {
    v1::Cheapest& cheapest = *study.mutable_trade()->add_cheapest();
    cheapest.set_tolerance(tolerance);
    if (const auto best = accuracy::cheapest(points, tolerance)) cheapest.set_run(numbers[*best]);
  }
}

}  // namespace

const v1::MeasureValue* find_measure(const v1::Run& run, const std::string& name) {
  const auto found = std::ranges::find_if(run.measures(),
                                          [&](const v1::MeasureValue& measure) { return measure.name() == name; });
  return found == run.measures().end() ? nullptr : &*found;
}

bool is_check(const v1::Scene& scene, const v1::MeasureValue& value) {
  const auto measure = std::ranges::find(scene.measures(), value.name(), &v1::Measure::name);
  if (measure == scene.measures().end()) return false;
  const auto exact = value.has_exact() ? std::optional(value.exact()) : std::nullopt;
  return accuracy::is_check(measure->quantity(), exact, measure->has_deviation());
}

void derive(v1::Study& study, const v1::Scene& scene) {
  if (study.job().study().kind() == "ladder") derive_ladder(study, scene);
  if (study.job().study().kind() == "tradeoff") derive_trade(study);
}

}  // namespace trajan
