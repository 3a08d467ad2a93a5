#include <fmt/format.h>

#include <iostream>

#include "client/commands/all.h"
#include "client/job_table.h"
#include "client/load_scene.h"
#include "client/private_server.h"
#include "client/terminal.h"

namespace trajan::client {
namespace {

struct CheckOptions {
  SceneSource scene;
  OutputFormat output = OutputFormat::table;
};

Table plan_table(const v1::Plan& plan) {
  Table table{{"plan", "value"}, {}};
  table.rows.push_back({std::string("particles"), plan.particles()});
  table.rows.push_back({std::string("active cells"), plan.active_cells()});
  table.rows.push_back({std::string("time step"), plan.time_step()});
  table.rows.push_back({std::string("limited by"), plan.time_step_limit()});
  table.rows.push_back({std::string("steps"), plan.steps()});
  table.rows.push_back({std::string("memory"), bytes_for_people(static_cast<double>(plan.memory_bytes()))});
  table.rows.push_back({std::string("result file"), bytes_for_people(static_cast<double>(plan.result_bytes()))});
  std::int64_t bytes = 0;
  for (const v1::Attribute& attribute : plan.attributes()) bytes += attribute.bytes_per_particle();
  if (bytes > 0) table.rows.push_back({std::string("bytes per particle"), bytes});
  return table;
}

v1::Plan plan_of(const GlobalOptions& global, const LoadedScene& scene) {
  if (!scene.text.has_structure()) fail_for_mistakes(scene, {});
  try {
    AvailableServer server(global.server);
    return check_scene(server.connection(), scene);
  } catch (const CommandError& error) {
    // Mistakes of spelling and form need no server.
    if (error.code == ExitCode::usage || scene.text.diagnostics().empty()) throw;
    fail_for_mistakes(scene, {});
  }
}

ExitCode check(const GlobalOptions& global, const CheckOptions& options) {
  const LoadedScene scene = load_scene(options.scene);
  const v1::Plan plan = plan_of(global, scene);
  if (options.output == OutputFormat::json || options.output == OutputFormat::jsonl) {
    std::cout << json_text(plan, options.output == OutputFormat::jsonl) << '\n';
  } else {
    print_table(std::cout, plan_table(plan), options.output);
  }
  return ExitCode::success;
}

}  // namespace

void declare_check(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto options = std::make_shared<CheckOptions>();
  add_scene_options(app, options->scene);
  add_output_option(app, options->output, {"table", "json", "jsonl", "csv"});
  set_action(app, global, action, options, check);
}

}  // namespace trajan::client
