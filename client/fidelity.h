#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "trajan/v1/fidelity.pb.h"

namespace trajan::client {

/// How accurate a run is to be, as the command line says it.
struct FidelityOptions {
  std::string preset;     ///< "preview", "standard" or "reference"; empty: none
  std::string tolerance;  ///< "MEASURE=0.5%" or "MEASURE=0.003"; empty: none
  double budget = 0;      ///< core-seconds; 0: the server's
};

/// `--fidelity`.
CLI::Option* add_preset_option(CLI::App& app, FidelityOptions& options);

/// That, `--tolerance` and `--budget`.
void add_fidelity_options(CLI::App& app, FidelityOptions& options);

/// Throws CommandError (usage).
v1::Fidelity parse_fidelity(const FidelityOptions& options);

}  // namespace trajan::client
