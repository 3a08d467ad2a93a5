#include "client/estimate_table.h"

#include <fmt/format.h>

#include <cmath>

#include "client/terminal.h"

namespace trajan::client {
namespace {

struct Shown {
  const char* name;
  const v1::Figure& figure;
  bool bytes = false;
};

Cell number(double value, bool bytes) { return bytes ? Cell(bytes_for_people(value)) : Cell(value); }

void add(Table& table, const Shown& shown) {
  const v1::Figure& figure = shown.figure;
  if (figure.source() == v1::Figure::SOURCE_UNSPECIFIED) return;
  table.rows.push_back({std::string(shown.name), number(figure.value(), shown.bytes),
                        figure.has_low() ? number(figure.low(), shown.bytes) : Cell(),
                        figure.has_high() ? number(figure.high(), shown.bytes) : Cell(),
                        source_name(figure.source()), figure.basis()});
}

/// By how much the figure is off; nothing if there is none.
Cell off(const v1::Figure& figure, double actual) {
  if (figure.source() == v1::Figure::SOURCE_UNSPECIFIED || !(actual > 0)) return {};
  return fmt::format("{:+.0f} %", 100 * (figure.value() / actual - 1));
}

Cell value_of(const v1::Figure& figure) {
  return figure.source() == v1::Figure::SOURCE_UNSPECIFIED ? Cell() : Cell(figure.value());
}

}  // namespace

std::string source_name(v1::Figure::Source source) {
  return source == v1::Figure::SOURCE_UNSPECIFIED ? "all" : v1::Figure::Source_Name(source);
}

Table figure_table(const v1::Estimate& estimate) {
  Table table{{"figure", "value", "low", "high", "source", "basis"}, {}};
  for (const Shown& shown :
       {Shown{"steps", estimate.steps()}, Shown{"time step", estimate.time_step()},
        Shown{"memory", estimate.memory_bytes(), true}, Shown{"core-seconds", estimate.core_seconds()},
        Shown{"seconds", estimate.wall_seconds()}, Shown{"result file", estimate.result_bytes(), true},
        Shown{"seconds in the queue", estimate.queue_seconds()}})
    add(table, shown);
  return table;
}

Table error_table(const v1::Estimate& estimate) {
  Table table{{"measure", "error", "low", "high", "source", "basis"}, {}};
  for (const v1::ErrorBand& band : estimate.errors()) add(table, {band.measure().c_str(), band.error()});
  return table;
}

Table neighbour_table(const v1::Estimate& estimate) {
  Table table{{"other settings", "cost", "error", "source", "in words"}, {}};
  for (const v1::Neighbour& neighbour : estimate.neighbours()) {
    std::string changes;
    for (const std::string& change : neighbour.changes()) changes += (changes.empty() ? "" : " ") + change;
    table.rows.push_back({changes, fmt::format("x {:.3g}", neighbour.cost_ratio()),
                          neighbour.has_error() ? Cell(neighbour.error()) : Cell(),
                          source_name(neighbour.source()), neighbour.text()});
  }
  return table;
}

Table audit_table(const v1::Audit& audit) {
  Table table{{"job", "scene", "source", "expected s", "low", "high", "took s", "off", "memory", "result"}, {}};
  for (const v1::Prediction& job : audit.predictions()) {
    const v1::Estimate& estimate = job.estimate();
    const v1::Figure& wall = estimate.wall_seconds();
    table.rows.push_back(
        {job.job_id(), job.scene_name(),
         wall.source() == v1::Figure::SOURCE_UNSPECIFIED ? Cell() : Cell(source_name(wall.source())),
         value_of(wall), wall.has_low() ? Cell(wall.low()) : Cell(), wall.has_high() ? Cell(wall.high()) : Cell(),
         job.cost().wall_seconds(), off(wall, job.cost().wall_seconds()),
         off(estimate.memory_bytes(), static_cast<double>(job.cost().memory_bytes())),
         off(estimate.result_bytes(), static_cast<double>(job.result_bytes()))});
  }
  return table;
}

Table coverage_table(const v1::Audit& audit) {
  Table table{{"figure", "source", "jobs", "in the interval", "within 25 %"}, {}};
  for (const v1::Coverage& coverage : audit.coverages()) {
    const auto share = [&](int count) {
      return fmt::format("{} ({:.0f} %)", count, 100.0 * count / std::max(coverage.jobs(), 1));
    };
    table.rows.push_back({coverage.figure(), source_name(coverage.source()),
                          static_cast<std::int64_t>(coverage.jobs()), share(coverage.within()),
                          share(coverage.within_quarter())});
  }
  return table;
}

std::string describe_expectation(const v1::Estimate& estimate) {
  const v1::Figure& wall = estimate.wall_seconds();
  if (wall.source() == v1::Figure::SOURCE_UNSPECIFIED) return {};
  return fmt::format("{:.3g} core-seconds, {:.3g} s ({:.3g} to {:.3g}, {}), {} for the job",
                     estimate.core_seconds().value(), wall.value(), wall.low(), wall.high(),
                     source_name(wall.source()), bytes_for_people(estimate.memory_bytes().value()));
}

}  // namespace trajan::client
