#include "server/estimate_errors.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "proto/field_change.h"
#include "server/convert.h"
#include "server/scene_digest.h"
#include "server/study_dials.h"
#include "solver/analyses/run.h"
#include "solver/cost/run_time.h"

namespace trajan {

namespace {

/// Linear functions and smooth answers.
constexpr double usual_order = 2;
/// By what an error may be off that was measured with the same settings, and with others for each doubling of
/// cells.
constexpr double same_factor = 1.2, doubling_factor = 1.5;

std::string method_bytes(const v1::Settings& settings) {
  v1::Settings method = settings;
  method.clear_cell_size();
  method.mutable_numerics()->clear_threads();
  return deterministic_bytes(method);
}

/// Errors of one measure by one method: of the smallest cells first.
std::map<double, const v1::Finding*> errors_by_cell(const v1::Scene& scene, const Evidence& evidence,
                                                    const std::string& measure) {
  const std::string method = method_bytes(settings_of(scene));
  std::map<double, const v1::Finding*> errors;
  for (const v1::Finding& finding : evidence.findings)
    if (finding.measure() == measure && finding.error() > 0 && method_bytes(finding.settings()) == method)
      errors[finding.settings().cell_size()] = &finding;
  return errors;
}

struct Order {
  double value = usual_order;
  bool measured = false;
};

/// Between the largest and the smallest cells.
Order order_of(const std::map<double, const v1::Finding*>& errors) {
  if (errors.size() < 2) return {};
  const auto &fine = *errors.begin(), &coarse = *errors.rbegin();
  const double order =
      std::log(coarse.second->error() / fine.second->error()) / std::log(coarse.first / fine.first);
  constexpr double lowest = 0.3, highest = 6;
  if (!(order > lowest && order < highest)) return {};
  return {order, true};
}

void add_error(const v1::Scene& scene, const Evidence& evidence, const std::string& measure,
               v1::Estimate& estimate) {
  const auto errors = errors_by_cell(scene, evidence, measure);
  if (errors.empty()) return;
  const double cell = scene.domain().cell_size();
  const auto near = std::ranges::min_element(
      errors, {}, [&](const auto& entry) { return std::abs(std::log2(entry.first / cell)); });
  const Order order = order_of(errors);
  const double doublings = std::log2(cell / near->first);
  const double error = near->second->error() * std::exp2(order.value * doublings);
  const double factor = same_factor * std::pow(doubling_factor, std::abs(doublings));
  const bool same = doublings == 0;
  v1::ErrorBand& band = *estimate.add_errors();
  band.set_measure(measure);
  v1::Figure& figure = *band.mutable_error();
  figure.set_value(error);
  figure.set_low(error / factor);
  figure.set_high(error * factor);
  figure.set_source(same || order.measured ? v1::Figure::HISTORY : v1::Figure::MODEL);
  char text[80];
  std::snprintf(text, sizeof text, "cells of %.6g, order %.2g %s", near->first, order.value,
                order.measured ? "as measured" : "assumed");
  figure.set_basis(same ? "a run with the same settings" : text);
}

/// "5 times the cost", "1/8 of the cost"
std::string times(double ratio, const char* of) {
  char text[64];
  if (ratio >= 1) {
    std::snprintf(text, sizeof text, "%.2g times the %s", ratio, of);
  } else {
    std::snprintf(text, sizeof text, "1/%.2g of the %s", 1 / ratio, of);
  }
  return text;
}

/// Core-seconds of a scene by rates or, without them, by counted steps; both only in comparison.
std::optional<double> cost_by_model(const v1::Scene& scene, const Evidence& evidence, int threads) {
  try {
    const Model model = validate(to_scene(scene));
    const ModelPlan planned = plan(model);
    if (!evidence.calibration) return static_cast<double>(planned.steps) * static_cast<double>(planned.particles);
    const auto& seconds = evidence.calibration->seconds();
    const auto time = run_time(model, planned, threads, Rates(seconds.begin(), seconds.end()));
    return time ? std::optional(time->core_seconds) : std::nullopt;
  } catch (const InvalidScene&) {
    return std::nullopt;
  }
}

/// Cells of twice and of half the size.
void add_other_cells(const v1::Scene& scene, const Evidence& evidence, v1::Estimate& estimate) {
  if (scene.measures().empty()) return;
  const std::string& measure = estimate.errors().empty() ? scene.measures(0).name() : estimate.errors(0).measure();
  const Order order = order_of(errors_by_cell(scene, evidence, measure));
  v1::Ladder ladder;
  ladder.set_finest(scene.domain().cell_size() / 2);
  const v1::Dial dial = ladder_dial(scene, ladder);
  const auto here = cost_by_model(scene, evidence, estimate.threads());
  for (const int level : {2, 0}) {
    v1::Scene other = scene;
    for (const std::string& change : dial.settings(level).changes()) change_field(other, change);
    const auto there = cost_by_model(other, evidence, estimate.threads());
    if (!here || !there || !(*here > 0)) continue;
    v1::Neighbour& neighbour = *estimate.add_neighbours();
    *neighbour.mutable_changes() = dial.settings(level).changes();
    neighbour.set_cost_ratio(*there / *here);
    neighbour.set_error_ratio(std::exp2(order.value * (level == 2 ? -1 : 1)));
    if (!estimate.errors().empty())
      neighbour.set_error(estimate.errors(0).error().value() * neighbour.error_ratio());
    neighbour.set_source(v1::Figure::MODEL);
    char text[64];
    std::snprintf(text, sizeof text, " (order %.2g %s)", order.value, order.measured ? "as measured" : "assumed");
    neighbour.set_text(times(neighbour.error_ratio(), "error") + " for " + times(neighbour.cost_ratio(), "cost") +
                       text);
  }
}

/// What makes the scene's settings those of a finding.
std::vector<std::string> changes_to(const v1::Settings& settings, const v1::Settings& wanted) {
  std::vector<std::string> changes;
  const auto add = [&](const std::string& path, const std::string& before, const std::string& after) {
    if (before != after && !after.empty()) changes.push_back(path + "=" + after);
  };
  const auto number = [](double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return std::string(text);
  };
  add("domain.cell_size", number(settings.cell_size()), number(wanted.cell_size()));
  add("bodies[0].particles_per_cell_side", std::to_string(settings.particles_per_cell_side()),
      std::to_string(wanted.particles_per_cell_side()));
  add("numerics.scheme", settings.numerics().scheme(), wanted.numerics().scheme());
  add("numerics.shape_functions", settings.numerics().shape_functions(), wanted.numerics().shape_functions());
  add("numerics.transfer", settings.numerics().transfer(), wanted.numerics().transfer());
  const auto kind = [](const v1::Settings& of) {
    const auto* field = v1::Analysis::descriptor()->FindFieldByNumber(of.analysis().kind_case());
    return field == nullptr ? std::string() : field->name();
  };
  if (kind(settings) != kind(wanted) && !kind(wanted).empty())
    changes.push_back("analysis." + kind(wanted) + "={}");
  return changes;
}

void add_known(const v1::Scene& scene, const v1::Finding* finding, v1::Estimate& estimate) {
  if (finding == nullptr) return;
  const v1::Settings settings = settings_of(scene);
  v1::Neighbour& neighbour = *estimate.add_neighbours();
  for (const std::string& change : changes_to(settings, finding->settings())) neighbour.add_changes(change);
  neighbour.set_cost_ratio(finding->cost().core_seconds() / estimate.core_seconds().value());
  neighbour.set_error(finding->error());
  if (!estimate.errors().empty()) neighbour.set_error_ratio(finding->error() / estimate.errors(0).error().value());
  neighbour.set_source(v1::Figure::HISTORY);
  char text[64];
  std::snprintf(text, sizeof text, "%.2g %% error for ", 100 * finding->error());
  neighbour.set_text(text + times(neighbour.cost_ratio(), "cost"));
}

/// Of finished runs: the cheapest with half the error, and the most accurate for a tenth of the cost.
void add_other_methods(const v1::Scene& scene, const Evidence& evidence, v1::Estimate& estimate) {
  if (!estimate.has_core_seconds()) return;
  const v1::Finding *cheap = nullptr, *accurate = nullptr;
  const std::string measure = estimate.errors().empty() ? "" : estimate.errors(0).measure();
  for (const v1::Finding& finding : evidence.findings) {
    if (!finding.has_error() || (!measure.empty() && finding.measure() != measure)) continue;
    const double cost = finding.cost().core_seconds();
    if (!measure.empty() && finding.error() <= estimate.errors(0).error().value() / 2 &&
        (cheap == nullptr || cost < cheap->cost().core_seconds()))
      cheap = &finding;
    if (cost <= estimate.core_seconds().value() / 10 &&
        (accurate == nullptr || finding.error() < accurate->error()))
      accurate = &finding;
  }
  add_known(scene, cheap, estimate);
  if (accurate != cheap) add_known(scene, accurate, estimate);
}

}  // namespace

void estimate_errors(const v1::Scene& scene, const Evidence& evidence, v1::Estimate& estimate) {
  for (const v1::Measure& measure : scene.measures()) add_error(scene, evidence, measure.name(), estimate);
}

void name_neighbours(const v1::Scene& scene, const Evidence& evidence, v1::Estimate& estimate) {
  add_other_cells(scene, evidence, estimate);
  add_other_methods(scene, evidence, estimate);
}

}  // namespace trajan
