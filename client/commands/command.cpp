#include "client/commands/command.h"

#include <map>

#include "client/commands/all.h"

namespace trajan::client {

std::span<const Command> commands() {
  static constexpr Command all[] = {
      {"run", "run a scene and bring back its results", declare_run},
      {"check", "say what is wrong with a scene, or what would be modelled", declare_check},
      {"scenes", "list the gallery, or print one of its scenes", declare_scenes},
      {"submit", "queue a scene and print the job's id", declare_submit},
      {"sweep", "run a scene with other values of its fields, and print a table", declare_sweep},
      {"study", "say how far a scene's measures are off, by a ladder of cell sizes", declare_study},
      {"tradeoff", "try settings of a scene: errors against core-seconds", declare_tradeoff},
      {"estimate", "say what a scene would take and how far off it would be", declare_estimate},
      {"watch", "follow a job or a study to its end", declare_watch},
      {"history", "print histories as CSV or JSON lines", declare_history},
      {"fetch", "download a job's result files", declare_fetch},
      {"plot", "draw histories or their spectra", declare_plot},
      {"render", "draw the particles, coloured by a field", declare_render},
      {"ls", "list jobs, newest first", declare_list},
      {"show", "show one job", declare_show},
      {"cancel", "stop jobs", declare_cancel},
      {"rm", "remove ended jobs and their files", declare_remove},
      {"serve", "start a server (trajand serve)", declare_delegated},
      {"work", "start a worker (trajand work)", declare_delegated},
      {"completion", "print the completion script of a shell", declare_completion},
  };
  return all;
}

void add_scene_options(CLI::App& app, SceneSource& scene) {
  app.add_option("scene", scene.name, "A scene file, - for standard input, or a gallery scene")->required();
  app.add_option("--set", scene.changes, "Another value of a field, as in domain.cell_size=0.1; may be repeated")
      ->type_name("PATH=VALUE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

void add_output_option(CLI::App& app, OutputFormat& output, const std::vector<std::string>& formats) {
  static const std::map<std::string, OutputFormat> known{{"table", OutputFormat::table},
                                                         {"json", OutputFormat::json},
                                                         {"jsonl", OutputFormat::jsonl},
                                                         {"csv", OutputFormat::csv}};
  app.add_option_function<std::string>(
         "-o,--output", [&output](const std::string& name) { output = known.at(name); }, "Format of the output")
      ->type_name("FORMAT")
      ->check(CLI::IsMember(formats));
}

Connection connect(const GlobalOptions& global) { return Connection(configured_address(global.server)); }

std::string resolve_job(Connection& connection, const std::string& job) {
  if (job != "last") return job;
  v1::ListJobsRequest request;
  request.set_page_size(1);
  const auto response = connection.call(&v1::Jobs::Stub::ListJobs, request);
  if (response.jobs().empty()) throw CommandError(ExitCode::not_found, "there is no job yet");
  return response.jobs(0).job_id();
}

}  // namespace trajan::client
