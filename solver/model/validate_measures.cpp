#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/sample_window.h"
#include "solver/model/validator.h"

namespace trajan {

void Validator::check_measures() {
  if (!check_list("measures", scene_.measures)) return;
  for (std::size_t i = 0; i < scene_.measures.size(); ++i) {
    check_measure(indexed("measures", i), scene_.measures[i]);
  }
}

void Validator::check_measure(const std::string& path, const MeasureDefinition& definition) {
  Measure measure;
  measure.name = definition.name;
  measure.quantity = definition.quantity;
  measure.source = definition.source;
  const auto column = std::ranges::find(columns_, definition.quantity);
  measure.column = static_cast<std::size_t>(column - columns_.begin());
  // What is wrong with a probe was said there.
  const std::string probe = definition.quantity.substr(0, definition.quantity.find('.'));
  if (column == columns_.end() && !columns_.empty() && !broken_probes_.contains(probe)) {
    unknown_name(path + ".quantity", definition.quantity, "history", columns_);
  }
  check_window(path, definition, measure);
  if (const auto* frequency = std::get_if<DominantFrequency>(&definition.kind)) {
    measure.kind = *frequency;
    check_frequency(path + ".dominant_frequency", *frequency);
  } else if (const auto* deviation = std::get_if<Deviation>(&definition.kind)) {
    measure.kind = *deviation;
    measure.exact = 0;
    measure.exact_history = history_formula(path + ".deviation.exact_history", deviation->exact_history);
    violations_.positive(path + ".deviation.scale", deviation->scale);
  } else if (std::holds_alternative<std::monostate>(definition.kind)) {
    violations_.add(path, "", "no way to measure is given",
                    "give final, extreme, mean, dominant_frequency or deviation");
  } else if (std::holds_alternative<ExtremeValue>(definition.kind)) {
    measure.kind = std::get<ExtremeValue>(definition.kind);
  } else if (std::holds_alternative<MeanValue>(definition.kind)) {
    measure.kind = MeanValue{};
  }
  check_exact(path, definition, measure);
  model_.measures.push_back(std::move(measure));
}

void Validator::check_window(const std::string& path, const MeasureDefinition& definition, Measure& measure) {
  const double end = model_.end_time;
  measure.from = definition.from;
  measure.until = definition.until.value_or(end);
  const bool from = violations_.not_negative(path + ".from", definition.from);
  const bool until = !definition.until || violations_.not_negative(path + ".until", *definition.until);
  if (!from || !until || !clock_complete_) return;
  if (definition.until && measure.until > end * (1 + node_tolerance)) {
    violations_.add(path + ".until", number_text(measure.until), "after the end of the analysis",
                    "give at most " + number_text(end) + " or leave it out");
    return;
  }
  const bool spectrum = std::holds_alternative<DominantFrequency>(definition.kind);
  const std::int64_t needed = spectrum ? fewest_samples_of_a_spectrum : 1;
  const std::int64_t count = sample_window(measure.from, measure.until, end, model_.outputs.samples).count();
  if (count < needed) {
    violations_.add(
        path + ".from", number_text(measure.from),
        (count > 0 ? "only " + std::to_string(count) + " samples lie" : "no sample lies") + " from then until " +
            number_text(measure.until),
        "give a longer time or more outputs.samples: at least " + std::to_string(needed) + " must lie there");
  }
}

void Validator::check_frequency(const std::string& path, const DominantFrequency& frequency) {
  const bool lowest = violations_.not_negative(path + ".lowest", frequency.lowest);
  const bool highest = !frequency.highest || violations_.positive(path + ".highest", *frequency.highest);
  if (!lowest || !highest || !clock_complete_) return;
  const double nyquist = static_cast<double>(model_.outputs.samples) / model_.end_time / 2;
  if (frequency.highest && *frequency.highest > nyquist) {
    violations_.add(path + ".highest", number_text(*frequency.highest), "above half the sampling rate",
                    "give at most " + number_text(nyquist) + " or more outputs.samples");
  } else if (frequency.lowest >= frequency.highest.value_or(nyquist)) {
    violations_.add(path + ".lowest", number_text(frequency.lowest), "not below the highest frequency",
                    "give less than " + number_text(frequency.highest.value_or(nyquist)));
  }
}

void Validator::check_exact(const std::string& path, const MeasureDefinition& definition, Measure& measure) {
  if (!definition.exact.empty()) {
    if (const auto exact = formula(path + ".exact", definition.exact, "")) measure.exact = (*exact)({}, 0);
  }
  measure.tolerance = definition.tolerance;
  if (!definition.tolerance) return;
  violations_.positive(path + ".tolerance", *definition.tolerance);
  if (definition.exact.empty() && !measure.exact) {
    violations_.add(path + ".tolerance", number_text(*definition.tolerance), "there is nothing to compare with",
                    "give exact as well, or leave it out");
  }
}

}  // namespace trajan
