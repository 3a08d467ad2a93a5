#include "client/fidelity.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "client/exit_code.h"

namespace trajan::client {
namespace {

/// A share if it ends in %, otherwise in the units of the measure.
void parse_tolerance(std::string_view text, v1::Target& target) {
  const bool is_share = text.ends_with('%');
  if (is_share) text.remove_suffix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !(number > 0)) {
    throw CommandError(ExitCode::usage, fmt::format("\"{}{}\" is not a tolerance", text, is_share ? "%" : ""),
                       "write 0.5% of the answer, or a number > 0 in the units of the measure");
  }
  if (is_share) {
    target.set_relative(number / 100);
  } else {
    target.set_absolute(number);
  }
}

v1::Target parse_target(const FidelityOptions& options) {
  const std::size_t equals = options.tolerance.find('=');
  if (equals == 0 || equals == std::string::npos) {
    throw CommandError(ExitCode::usage,
                       fmt::format("--tolerance {}: it is not MEASURE=TOLERANCE", options.tolerance),
                       "as in tip_deflection=0.5%");
  }
  v1::Target target;
  target.set_measure(options.tolerance.substr(0, equals));
  parse_tolerance(std::string_view(options.tolerance).substr(equals + 1), target);
  if (options.budget > 0) target.set_budget_core_seconds(options.budget);
  return target;
}

}  // namespace

CLI::Option* add_preset_option(CLI::App& app, FidelityOptions& options) {
  return app
      .add_option("--fidelity", options.preset,
                  "preview: cells twice as large; standard: as the scene says; reference: cells half as "
                  "large. A constant \"cell\" and given time steps go with them")
      ->type_name("PRESET")
      ->check(CLI::IsMember({"preview", "standard", "reference"}));
}

void add_fidelity_options(CLI::App& app, FidelityOptions& options) {
  auto* preset = add_preset_option(app, options);
  auto* tolerance = app.add_option("--tolerance", options.tolerance,
                                   "Find settings by which a measure is as exact as this, as in "
                                   "tip_deflection=0.5% or tip_deflection=0.003, and answer by them")
                        ->type_name("MEASURE=TOLERANCE")
                        ->excludes(preset);
  app.add_option("--budget", options.budget, "Most core-seconds for --tolerance (default: 600)")
      ->type_name("CORE_SECONDS")
      ->check(CLI::PositiveNumber)
      ->needs(tolerance);
}

v1::Fidelity parse_fidelity(const FidelityOptions& options) {
  v1::Fidelity fidelity;
  if (options.preset == "preview") fidelity.set_preset(v1::PREVIEW);
  if (options.preset == "standard") fidelity.set_preset(v1::STANDARD);
  if (options.preset == "reference") fidelity.set_preset(v1::REFERENCE);
  if (!options.tolerance.empty()) *fidelity.mutable_target() = parse_target(options);
  return fidelity;
}

}  // namespace trajan::client
