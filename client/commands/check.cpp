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
  bool plan = false;
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

Table memory_table(const v1::Plan& plan) {
  const auto size = [](std::int64_t bytes) { return bytes_for_people(static_cast<double>(bytes)); };
  const std::string tiles =
      fmt::format("{} tiles of 64 cells, {} with particles", plan.tiles(), plan.occupied_tiles());
  Table table{{"memory", "bytes", "of what"}, {}};
  table.rows.push_back(
      {std::string("particles"), size(plan.particle_bytes()), fmt::format("{} particles", plan.particles())});
  table.rows.push_back({std::string("grid"), size(plan.grid_bytes()), tiles});
  if (plan.matrix_bytes() > 0)
    table.rows.push_back(
        {std::string("matrices"), size(plan.matrix_bytes()), std::string("without their factors")});
  return table;
}

Table particle_table(const v1::Plan& plan) {
  Table table{{"per particle", "bytes", "asked for by"}, {}};
  for (const v1::Attribute& row : plan.attributes())
    table.rows.push_back({row.name(), std::int64_t{row.bytes_per_particle()}, row.wanted_by()});
  return table;
}

Table node_table(const v1::Plan& plan) {
  Table table{{"per node", "bytes", "asked for by"}, {}};
  for (const v1::NodeAttribute& row : plan.node_attributes())
    table.rows.push_back({row.name(), std::int64_t{row.bytes_per_node()}, row.wanted_by()});
  return table;
}

Table sweep_table(const v1::Plan& plan) {
  Table table{{"sweep", "bodies", "what is done to a block of particles, in order"}, {}};
  std::int64_t number = 0;
  for (const v1::ParticleSweep& sweep : plan.sweeps()) {
    ++number;
    for (const auto& of_bodies : sweep.of_bodies()) {
      const std::string bodies = fmt::format("{}", fmt::join(of_bodies.bodies(), ", "));
      for (const std::string& stage : of_bodies.stages()) table.rows.push_back({number, bodies, stage});
    }
  }
  return table;
}

/// What will be modelled, all of it.
void print_parts(const v1::Plan& plan) {
  for (const Table& table : {memory_table(plan), particle_table(plan), node_table(plan), sweep_table(plan)}) {
    std::cout << '\n';
    if (table.rows.empty())
      std::cout << "no explicit steps: the analysis solves for the displacements of the nodes\n";
    else
      print_table(std::cout, table, OutputFormat::table);
  }
  if (!plan.sweeps().empty())
    std::cout << "\nsweeps are those of one step; sum.: what particles scatter to the nodes around their tile\n";
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
  if (options.plan && options.output == OutputFormat::csv)
    throw CommandError(ExitCode::usage, "--plan makes several tables: choose -o table, json or jsonl");
  const LoadedScene scene = load_scene(options.scene);
  const v1::Plan plan = plan_of(global, scene);
  if (options.output == OutputFormat::json || options.output == OutputFormat::jsonl) {
    std::cout << json_text(plan, options.output == OutputFormat::jsonl) << '\n';
  } else {
    print_table(std::cout, plan_table(plan), options.output);
    if (options.plan) print_parts(plan);
  }
  return ExitCode::success;
}

}  // namespace

void declare_check(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto options = std::make_shared<CheckOptions>();
  add_scene_options(app, options->scene);
  add_output_option(app, options->output, {"table", "json", "jsonl", "csv"});
  app.add_flag("--plan", options->plan, "Also what particles and nodes carry, for whom, and what each step does");
  set_action(app, global, action, options, check);
}

}  // namespace trajan::client
