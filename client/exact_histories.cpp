#include "client/exact_histories.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <numbers>

#include "client/terminal.h"

namespace trajan::client {
namespace {

/// The scene's constants, by name. Throws mu::ParserError.
void define_constants(mu::Parser& parser, const v1::Scene& scene) {
  parser.ClearConst();
  parser.DefineConst("pi", std::numbers::pi);
  for (const v1::Constant& constant : scene.constants()) {
    parser.SetExpr(constant.value());
    const double value = parser.Eval();
    parser.DefineConst(constant.name(), value);
  }
}

/// A formula of t from time 0 to the end, at a few points for each pixel. Throws mu::ParserError.
ExactHistory curve(const v1::Scene& scene, const v1::Measure& measure) {
  constexpr int intervals = 4000;
  mu::Parser parser;
  define_constants(parser, scene);
  double t = 0;
  parser.DefineVar("t", &t);
  parser.SetExpr(measure.deviation().exact_history());
  ExactHistory exact{measure.quantity(), measure.name(), {}, {}};
  for (int i = 0; i <= intervals; ++i) {
    t = scene.analysis().end_time() * i / intervals;
    exact.time.push_back(t);
    exact.value.push_back(parser.Eval());
  }
  return exact;
}

void add(std::vector<ExactHistory>& all, ExactHistory exact) {
  const bool known = std::ranges::any_of(all, [&exact](const ExactHistory& other) {
    return other.column == exact.column && other.time == exact.time && other.value == exact.value;
  });
  if (!known) all.push_back(std::move(exact));
}

void add_value(std::vector<ExactHistory>& all, const v1::Job& job, const v1::Measure& measure) {
  const double until = measure.has_until() ? measure.until() : job.scene().analysis().end_time();
  for (const v1::MeasureValue& value : job.measures()) {
    if (value.name() != measure.name() || !value.has_exact()) continue;
    add(all, {measure.quantity(), measure.name(), {measure.from(), until}, {value.exact(), value.exact()}});
  }
}

}  // namespace

std::vector<ExactHistory> exact_histories(const v1::Job& job) {
  std::vector<ExactHistory> all;
  for (const v1::Measure& measure : job.scene().measures()) {
    if (measure.has_final() || measure.has_mean() || measure.has_extreme()) add_value(all, job, measure);
    if (!measure.has_deviation()) continue;
    try {
      add(all, curve(job.scene(), measure));
    } catch (const mu::ParserError& error) {
      say(fmt::format("the exact history of measure \"{}\" is left out: {}", measure.name(), error.GetMsg()));
    }
  }
  return all;
}

}  // namespace trajan::client
