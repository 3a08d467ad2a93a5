#pragma once

#include "client/commands/command.h"

namespace trajan::client {

void declare_run(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_check(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_scenes(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_submit(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_sweep(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_study(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_tradeoff(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_estimate(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_watch(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_history(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_fetch(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_plot(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_render(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_list(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_show(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_cancel(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_remove(CLI::App& app, const GlobalOptions& global, Action& action);
/// The commands that trajand does.
void declare_delegated(CLI::App& app, const GlobalOptions& global, Action& action);
void declare_completion(CLI::App& app, const GlobalOptions& global, Action& action);

}  // namespace trajan::client
