// The commands that make studies of a scene: sweep.
#include <fmt/format.h>

#include <iostream>

#include "client/commands/all.h"
#include "client/follow_job.h"
#include "client/load_scene.h"
#include "client/over.h"
#include "client/private_server.h"
#include "client/progress_display.h"
#include "client/study.h"
#include "client/submission.h"
#include "client/terminal.h"

namespace trajan::client {
namespace {

/// What all studies are asked with.
struct StudyOptions {
  SceneSource scene;
  std::vector<std::string> labels;
  int priority = 0;
  bool wait = true;
  bool run_all = false;
  OutputFormat output = OutputFormat::table;
};

v1::SubmitStudyRequest request_of(const StudyOptions& options) {
  v1::SubmitStudyRequest request;
  *request.mutable_labels() = parse_labels(options.labels);
  request.set_priority(options.priority);
  request.set_run_all(options.run_all);
  return request;
}

/// A private server dies with this process, and its studies with it.
ExitCode follow_study(AvailableServer& server, const std::string& job_id, OutputFormat output) {
  InterruptWatch interrupt;
  v1::Job job;
  {
    ProgressDisplay display(is_terminal());
    job = follow_job(server.connection(), job_id, 0, interrupt, display);
  }
  if (has_ended(job.state())) return report_study(server.connection(), job, output);
  if (!server.is_private()) say(fmt::format("detached; the study goes on. Resume with: trajan watch {}", job_id));
  return ExitCode::detached;
}

ExitCode perform_study(const GlobalOptions& global, const StudyOptions& options,
                       const v1::SubmitStudyRequest& request) {
  const LoadedScene scene = load_scene(options.scene);
  if (!options.wait) {
    Connection connection = connect(global);
    const std::string job_id = submit_study(connection, scene, request).job_id();
    std::cout << job_id << '\n';
    say(fmt::format("follow it with: trajan watch {}", job_id));
    return ExitCode::success;
  }
  AvailableServer server(global.server);
  const std::string job_id = submit_study(server.connection(), scene, request).job_id();
  if (!server.is_private()) say("study " + job_id);
  return follow_study(server, job_id, options.output);
}

void add_study_options(CLI::App& app, StudyOptions& options) {
  add_scene_options(app, options.scene);
  app.add_option("--label", options.labels, "A label of the study; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  app.add_option("--priority", options.priority, "Of every run")->check(CLI::Range(-100, 100));
  app.add_flag("--wait,!--detach", options.wait,
               "Follow the study and print its table (default), or its id alone");
  app.add_flag("--run-all", options.run_all, "Compute also what has been computed before");
  add_output_option(app, options.output, {"table", "json", "jsonl", "csv"});
}

struct SweepOptions {
  StudyOptions study;
  std::vector<std::string> over;
};

ExitCode sweep(const GlobalOptions& global, const SweepOptions& asked) {
  v1::SubmitStudyRequest request = request_of(asked.study);
  for (const std::string& over : asked.over) *request.mutable_sweep()->add_dials() = parse_over(over);
  return perform_study(global, asked.study, request);
}

}  // namespace

void declare_sweep(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<SweepOptions>();
  add_study_options(app, asked->study);
  app.add_option("--over", asked->over,
                 "Values of a field, v1,v2,... or from:to:count; repeated: all combinations")
      ->type_name("PATH=VALUES")
      ->required()
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  app.footer(
      "As in: trajan sweep cantilever --over domain.cell_size=0.25,0.125 --over numerics.scheme=MUSL,TLMPM");
  set_action(app, global, action, asked, sweep);
}

}  // namespace trajan::client
