#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <span>
#include <string>

#include "client/connection.h"
#include "client/load_scene.h"
#include "client/table.h"

namespace trajan::client {

/// Options that every command has.
struct GlobalOptions {
  std::string server;
};

/// What the command line asks for; returns the exit code.
using Action = std::function<ExitCode()>;

/// One word of the command line. The table of them makes the help, the completion and the manual.
struct Command {
  const char* name;
  const char* summary;
  /// Declares options and arguments, and the callback that sets `action`. `global` and `action` outlive `app`.
  void (*declare)(CLI::App& app, const GlobalOptions& global, Action& action);
};

/// All of them, in the order of the help.
std::span<const Command> commands();

/// Sets `action` to `perform(global, options)` when the command is given.
template <typename Options>
void set_action(CLI::App& app, const GlobalOptions& global, Action& action, std::shared_ptr<Options> options,
                ExitCode (*perform)(const GlobalOptions&, const Options&)) {
  app.callback([&global, &action, options, perform] {
    action = [&global, options, perform] { return perform(global, *options); };
  });
}

/// The argument `scene` and `--set PATH=VALUE`.
void add_scene_options(CLI::App& app, SceneSource& scene);

/// `-o, --output FORMAT`, one of `formats`.
void add_output_option(CLI::App& app, OutputFormat& output, const std::vector<std::string>& formats);

/// Becomes `trajand` if the first word is one of its commands; otherwise returns. Throws CommandError.
void become_trajand(int count, char** words);

Connection connect(const GlobalOptions& global);

/// The job's id; `last` is the newest job. Throws CommandError.
std::string resolve_job(Connection& connection, const std::string& job);

}  // namespace trajan::client
