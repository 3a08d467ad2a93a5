#include "server/audit.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace trajan {

namespace {

/// Intervals are meant to hold so often.
constexpr double confidence = 0.9;
constexpr std::size_t enough = 19;  ///< the second largest of 19 errors is not exceeded nine times in ten

struct Compared {
  const char* name;
  const v1::Figure& (*figure)(const v1::Estimate&);
  double (*actual)(const v1::Prediction&);
};

const Compared compared[] = {
    {"steps", [](const v1::Estimate& e) -> const v1::Figure& { return e.steps(); },
     [](const v1::Prediction& p) { return static_cast<double>(p.steps()); }},
    {"core_seconds", [](const v1::Estimate& e) -> const v1::Figure& { return e.core_seconds(); },
     [](const v1::Prediction& p) { return p.cost().core_seconds(); }},
    {"wall_seconds", [](const v1::Estimate& e) -> const v1::Figure& { return e.wall_seconds(); },
     [](const v1::Prediction& p) { return p.cost().wall_seconds(); }},
    {"memory_bytes", [](const v1::Estimate& e) -> const v1::Figure& { return e.memory_bytes(); },
     [](const v1::Prediction& p) { return static_cast<double>(p.cost().memory_bytes()); }},
    {"result_bytes", [](const v1::Estimate& e) -> const v1::Figure& { return e.result_bytes(); },
     [](const v1::Prediction& p) { return static_cast<double>(p.result_bytes()); }},
};

void count(const v1::Figure& figure, double actual, v1::Coverage& coverage) {
  constexpr double quarter = 0.25;
  coverage.set_jobs(coverage.jobs() + 1);
  const bool within = figure.has_low() && figure.low() <= actual && actual <= figure.high();
  const bool near = std::abs(figure.value() - actual) <= quarter * actual;
  coverage.set_within(coverage.within() + (within ? 1 : 0));
  coverage.set_within_quarter(coverage.within_quarter() + (near ? 1 : 0));
}

}  // namespace

google::protobuf::RepeatedPtrField<v1::Coverage> coverages(const std::vector<v1::Prediction>& predictions) {
  google::protobuf::RepeatedPtrField<v1::Coverage> all;
  for (const Compared& what : compared) {
    std::map<int, v1::Coverage> by_source;
    for (const v1::Prediction& prediction : predictions) {
      const v1::Figure& figure = what.figure(prediction.estimate());
      if (figure.source() == v1::Figure::SOURCE_UNSPECIFIED || !prediction.has_cost()) continue;
      for (const int source :
           {static_cast<int>(v1::Figure::SOURCE_UNSPECIFIED), static_cast<int>(figure.source())})
        count(figure, what.actual(prediction), by_source[source]);
    }
    for (auto& [source, coverage] : by_source) {
      coverage.set_figure(what.name);
      coverage.set_source(static_cast<v1::Figure::Source>(source));
      *all.Add() = coverage;
    }
  }
  return all;
}

std::optional<double> usual_factor(const std::vector<v1::Prediction>& predictions, v1::Figure::Source source) {
  std::vector<double> factors;
  for (const v1::Prediction& prediction : predictions) {
    const v1::Figure& figure = prediction.estimate().wall_seconds();
    const double actual = prediction.cost().wall_seconds();
    if (figure.source() != source || !(figure.value() > 0) || !(actual > 0)) continue;
    factors.push_back(std::exp(std::abs(std::log(figure.value() / actual))));
  }
  if (factors.size() < enough) return std::nullopt;
  std::ranges::sort(factors);
  // Of n + 1 equally likely ranks of the next one.
  const auto rank = static_cast<std::size_t>(std::ceil(confidence * static_cast<double>(factors.size() + 1)));
  return factors[std::min(rank, factors.size()) - 1];
}

}  // namespace trajan
