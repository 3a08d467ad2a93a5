#include <fmt/format.h>

#include <iostream>
#include <thread>

#include "client/commands/all.h"
#include "client/estimate_table.h"
#include "client/job_table.h"
#include "client/load_scene.h"
#include "client/private_server.h"
#include "client/terminal.h"

namespace trajan::client {
namespace {

struct EstimateOptions {
  SceneSource scene;
  double probe = 0.8;
  bool audit = false;
  int most = 1000;
  OutputFormat output = OutputFormat::table;
};

void print_tables(const std::vector<Table>& tables, OutputFormat output) {
  bool first = true;
  for (const Table& table : tables) {
    if (table.rows.empty()) continue;
    if (!std::exchange(first, false)) std::cout << '\n';
    print_table(std::cout, table, output);
  }
}

void print(const google::protobuf::Message& message, const std::vector<Table>& tables, OutputFormat output) {
  if (output == OutputFormat::json || output == OutputFormat::jsonl) {
    std::cout << json_text(message, output == OutputFormat::jsonl) << '\n';
  } else {
    print_tables(tables, output);
  }
}

ExitCode audit(const GlobalOptions& global, const EstimateOptions& asked) {
  Connection connection = connect(global);
  v1::AuditEstimatesRequest request;
  request.set_most(asked.most);
  const v1::Audit audit = connection.call(&v1::Estimates::Stub::AuditEstimates, request);
  print(audit, {audit_table(audit), coverage_table(audit)}, asked.output);
  return ExitCode::success;
}

v1::Estimate ask(Connection& connection, const LoadedScene& scene, double probe) {
  v1::EstimateJobRequest request;
  *request.mutable_scene() = scene.text.scene();
  request.set_probe_seconds(probe);
  return connection.call(&v1::Estimates::Stub::EstimateJob, request);
}

/// A private server has to measure the machine first.
v1::Estimate ask_until_measured(AvailableServer& server, const LoadedScene& scene, double probe) {
  constexpr auto patience = std::chrono::seconds(60);
  const auto give_up = std::chrono::steady_clock::now() + patience;
  v1::Estimate estimate = ask(server.connection(), scene, probe);
  if (!server.is_private() || estimate.has_wall_seconds()) return estimate;
  say("measuring this machine, which a server of its own does once: trajan serve");
  while (!estimate.has_wall_seconds() && std::chrono::steady_clock::now() < give_up) {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    estimate = ask(server.connection(), scene, probe);
  }
  return estimate;
}

ExitCode estimate(const GlobalOptions& global, const EstimateOptions& asked) {
  if (asked.audit) return audit(global, asked);
  if (asked.scene.name.empty()) throw CommandError(ExitCode::usage, "say which scene, or --audit");
  const LoadedScene scene = load_scene(asked.scene);
  if (!scene.text.has_structure()) fail_for_mistakes(scene, {});
  AvailableServer server(global.server, true);
  check_scene(server.connection(), scene);
  const v1::Estimate estimate = ask_until_measured(server, scene, asked.probe);
  print(estimate, {figure_table(estimate), error_table(estimate), neighbour_table(estimate)}, asked.output);
  if (!estimate.missing().empty()) say("missing: " + estimate.missing());
  return ExitCode::success;
}

}  // namespace

void declare_estimate(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<EstimateOptions>();
  add_scene_options(app, asked->scene);
  app.get_option("scene")->required(false);
  app.add_option("--probe", asked->probe, "Run the scene for so long to see how fast it goes; 0: not at all")
      ->type_name("SECONDS")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 20.0));
  app.add_flag("--audit", asked->audit, "What was expected of finished jobs beside what they took");
  app.add_option("-n,--most", asked->most, "Of the audit: jobs at most")->check(CLI::Range(1, 10000));
  add_output_option(app, asked->output, {"table", "json", "jsonl", "csv"});
  app.footer(
      "Figures come from MODEL (counted work and this machine's rates), PROBE (a trial run) or HISTORY (finished\n"
      "runs of the same scene with other settings). Intervals are meant to hold in nine of ten cases.");
  set_action(app, global, action, asked, estimate);
}

}  // namespace trajan::client
