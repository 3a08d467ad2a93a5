#include "client/study_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <ostream>

#include "client/job_table.h"
#include "client/progress_display.h"

namespace trajan::client {
namespace {

/// Names of all measures in the order of the first run that has any, and whether they have exact values.
std::vector<std::pair<std::string, bool>> measures_of(const v1::Study& study) {
  std::vector<std::pair<std::string, bool>> names;
  const auto run =
      std::ranges::find_if(study.runs(), [](const v1::Run& each) { return !each.measures().empty(); });
  if (run == study.runs().end()) return names;
  for (const v1::MeasureValue& measure : run->measures()) names.emplace_back(measure.name(), measure.has_error());
  return names;
}

void add(std::vector<Cell>& row, std::optional<double> number) {
  if (number) {
    row.emplace_back(*number);
  } else {
    row.emplace_back();
  }
}

std::vector<Cell> row_of(const v1::Study& study, const v1::Run& run,
                         const std::vector<std::pair<std::string, bool>>& measures, bool with_answers) {
  std::vector<Cell> row{run.job_id(), state_name(run.state())};
  for (const std::string& setting : run.settings()) row.emplace_back(setting);
  std::map<std::string, const v1::MeasureValue*> values;
  for (const v1::MeasureValue& measure : run.measures()) values[measure.name()] = &measure;
  for (const auto& [name, has_error] : measures) {
    const auto found = values.find(name);
    const v1::MeasureValue* measure = found == values.end() ? nullptr : found->second;
    add(row, measure == nullptr ? std::nullopt : std::optional(measure->value()));
    if (has_error)
      add(row, measure == nullptr || !measure->has_error() ? std::nullopt : std::optional(measure->error()));
  }
  if (study.has_trade()) {
    add(row, run.has_error() ? std::optional(run.error()) : std::nullopt);
    row.emplace_back(std::string(run.pareto() ? "*" : ""));
  }
  add(row, run.has_cost() ? std::optional(run.cost().core_seconds()) : std::nullopt);
  if (with_answers && run.answered_by().empty()) row.emplace_back();
  if (with_answers && !run.answered_by().empty()) row.emplace_back(run.answered_by());
  return row;
}

std::string behaviour_name(v1::Convergence::Behaviour behaviour) {
  switch (behaviour) {
    case v1::Convergence::MONOTONE:
      return "monotone";
    case v1::Convergence::OSCILLATING:
      return "oscillating";
    case v1::Convergence::NOT_CONVERGING:
      return "not converging";
    case v1::Convergence::CONSTANT:
      return "constant";
    default:
      return "unknown";
  }
}

std::string claim_of(const v1::Convergence& convergence) {
  if (!convergence.has_band()) return "no claim: " + convergence.no_claim();
  return convergence.asymptotic() ? "in the asymptotic range" : "cautious";
}

/// Each once, with the runs that it is of.
void print_warnings(std::ostream& out, const v1::Study& study) {
  std::map<std::string, std::pair<std::string, const v1::Warning*>> runs;
  for (const v1::Run& run : study.runs())
    for (const v1::Warning& warning : run.warnings()) {
      auto& [of, first] = runs[warning.name()];
      of += (of.empty() ? "" : ", ") + run.job_id();
      if (first == nullptr) first = &warning;
    }
  if (!runs.empty()) out << '\n';
  for (const auto& [name, found] : runs)
    out << fmt::format("warning of {}: {}; {}\n", found.first, found.second->cause(), found.second->remedy());
}

void print_trade(std::ostream& out, const v1::Study& study) {
  const v1::Trade& trade = study.trade();
  out << fmt::format("\nThe cheapest within a tolerance of {}, against {} {:.6g}", trade.measure(),
                     trade.reference_source() == "exact" ? "the exact value" : "the extrapolated value",
                     trade.reference());
  if (trade.has_reference_band()) out << fmt::format(" +- {:.2g}", trade.reference_band());
  out << ":\n";
  print_table(out, cheapest_table(study), OutputFormat::table);
  std::map<std::string, int> failures;
  for (const v1::Run& run : study.runs()) {
    if (run.has_failure()) ++failures[run.failure().reason()];
  }
  for (const auto& [reason, count] : failures) out << fmt::format("\n{} runs failed: {}\n", count, reason);
  int left_out = 0;
  for (const v1::Skipped& skipped : trade.skipped()) left_out += skipped.combinations();
  if (left_out > 0) out << fmt::format("\n{} combinations are not valid:\n", left_out);
  for (const v1::Skipped& skipped : trade.skipped())
    out << fmt::format("  {:4d}  {}\n", skipped.combinations(), skipped.reason());
}

}  // namespace

Table run_table(const v1::Study& study) {
  const auto measures = measures_of(study);
  const bool with_answers =
      std::ranges::any_of(study.runs(), [](const v1::Run& run) { return !run.answered_by().empty(); });
  Table table{{"job", "state"}, {}};
  for (const std::string& dial : study.dials()) table.columns.push_back(dial);
  for (const auto& [name, has_error] : measures) {
    table.columns.push_back(name);
    if (has_error) table.columns.push_back(name + ".error");
  }
  if (study.has_trade()) table.columns.insert(table.columns.end(), {"error", "pareto"});
  table.columns.emplace_back("core_seconds");
  if (with_answers) table.columns.emplace_back("answered_by");
  for (const v1::Run& run : study.runs()) table.rows.push_back(row_of(study, run, measures, with_answers));
  return table;
}

Table convergence_table(const v1::Study& study) {
  Table table{{"measure", "finest_value", "behaviour", "order", "extrapolated", "band", "exact", "claim"}, {}};
  for (const v1::Convergence& each : study.convergences()) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row.emplace_back(each.measure());
    row.emplace_back(each.values(each.values_size() - 1));
    row.emplace_back(behaviour_name(each.behaviour()));
    add(row, each.has_order() ? std::optional(each.order()) : std::nullopt);
    add(row, each.has_extrapolated() ? std::optional(each.extrapolated()) : std::nullopt);
    add(row, each.has_band() ? std::optional(each.band()) : std::nullopt);
    add(row, each.has_exact() ? std::optional(each.exact()) : std::nullopt);
    row.emplace_back(claim_of(each));
  }
  return table;
}

Table cheapest_table(const v1::Study& study) {
  Table table{{"tolerance", "job", "settings", "error", "core_seconds"}, {}};
  for (const v1::Cheapest& each : study.trade().cheapest()) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row.emplace_back(fmt::format("{:g} %", 100 * each.tolerance()));
    if (!each.has_run()) {
      row.resize(table.columns.size());
      continue;
    }
    const v1::Run& run = study.runs(each.run());
    row.emplace_back(run.job_id());
    row.emplace_back(fmt::format("{}", fmt::join(run.settings(), "; ")));
    row.emplace_back(run.error());
    row.emplace_back(run.cost().core_seconds());
  }
  return table;
}

void print_answer(std::ostream& out, const v1::Study& study) {
  if (!study.has_answer()) return;
  const v1::Answer& answer = study.answer();
  const v1::Run& run = study.runs(answer.run());
  const v1::Target& target = study.target();
  std::string value = fmt::format("{:.6g}", answer.value());
  if (answer.has_band())
    value += fmt::format(" +- {:.2g} ({:.2g} %)", answer.band(), 100 * answer.band() / std::abs(answer.value()));
  const std::string tolerance = target.has_relative() ? fmt::format("{:g} %", 100 * target.relative())
                                                      : fmt::format("{:g}", target.absolute());
  const auto add = [&out](std::string_view name, const std::string& text) {
    out << fmt::format("{:<10} {}\n", name, text);
  };
  add("answer", fmt::format("{} = {}", target.measure(), value));
  add("tolerance", tolerance + (answer.reached() ? "" : ", NOT REACHED: " + answer.end()));
  add("by", fmt::format("{}, domain.cell_size={} (job {})", run.settings(0), run.settings(1), run.job_id()));
  add("cost", fmt::format("{:.3g} core-seconds, {:.3g} with the runs that led to it", run.cost().core_seconds(),
                          answer.core_seconds()));
}

void print_study_table(std::ostream& out, const v1::Study& study, OutputFormat output) {
  if (output == OutputFormat::json) {
    out << json_text(study, false);
    return;
  }
  print_table(out, run_table(study), output);
  if (output != OutputFormat::table) return;
  print_warnings(out, study);
  if (!study.convergences().empty()) {
    out << '\n';
    print_table(out, convergence_table(study), output);
  }
  if (study.has_trade()) print_trade(out, study);
  if (study.has_answer()) {
    out << '\n';
    print_answer(out, study);
  }
}

}  // namespace trajan::client
