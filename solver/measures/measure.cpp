#include "solver/measures/measure.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "solver/measures/spectrum.h"
#include "solver/model/sample_window.h"

namespace trajan {

namespace {

/// The samples of one column that count.
struct Series {
  std::vector<double> time;
  std::vector<double> values;
};

double value(const FinalValue&, const Measure&, const Series& series) { return series.values.back(); }

double value(const ExtremeValue& extreme, const Measure&, const Series& series) {
  switch (extreme.kind) {
    case ExtremeKind::maximum:
      return std::ranges::max(series.values);
    case ExtremeKind::minimum:
      return std::ranges::min(series.values);
    case ExtremeKind::magnitude:
      break;
  }
  return std::ranges::max(series.values, {}, [](double v) { return std::abs(v); });
}

/// By the trapezoid rule.
double value(const MeanValue&, const Measure&, const Series& series) {
  const auto& [time, values] = series;
  if (values.size() == 1) return values.front();
  double integral = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    integral += (values[i] + values[i - 1]) / 2 * (time[i] - time[i - 1]);
  }
  return integral / (time.back() - time.front());
}

double value(const DominantFrequency& frequency, const Measure&, const Series& series) {
  const double interval = (series.time.back() - series.time.front()) / static_cast<double>(series.time.size() - 1);
  return dominant_frequency(series.values, interval, frequency.lowest,
                            frequency.highest.value_or(1 / (2 * interval)));
}

double value(const Deviation& deviation, const Measure& measure, const Series& series) {
  double largest = 0;
  for (std::size_t i = 0; i < series.values.size(); ++i) {
    const double exact = (*measure.exact_history)(0, 0, series.time[i]);
    const double distance = std::abs(series.values[i] - exact) / deviation.scale;
    if (std::isnan(distance)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, distance);
  }
  return largest;
}

Series select(const Model& model, const Measure& measure, std::span<const double> time,
              std::span<const double> values) {
  const SampleWindow window = sample_window(measure.from, measure.until, model.end_time, model.outputs.samples);
  const std::size_t columns = values.size() / time.size();
  Series series;
  for (std::int64_t i = window.first; i <= window.last; ++i) {
    const auto row = static_cast<std::size_t>(i);
    series.time.push_back(time[row]);
    series.values.push_back(values[row * columns + measure.column]);
  }
  return series;
}

/// (value - exact) / |exact|, or the value itself where the exact one is 0.
double error(double value, double exact) { return exact == 0 ? value : (value - exact) / std::abs(exact); }

}  // namespace

std::vector<MeasureValue> evaluate(const Model& model, std::span<const double> time,
                                   std::span<const double> values) {
  assert(static_cast<std::int64_t>(time.size()) == model.outputs.samples + 1);
  assert(values.size() == time.size() * history_columns(model).size());
  std::vector<MeasureValue> results;
  for (const Measure& measure : model.measures) {
    const Series series = select(model, measure, time, values);
    MeasureValue result;
    result.name = measure.name;
    result.quantity = measure.quantity;
    result.value = std::visit([&](const auto& kind) { return value(kind, measure, series); }, measure.kind);
    result.exact = measure.exact;
    if (result.exact) result.error = error(result.value, *result.exact);
    result.tolerance = measure.tolerance;
    result.source = measure.source;
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace trajan
