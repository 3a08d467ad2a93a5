#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>

#include "client/commands/all.h"
#include "client/follow_job.h"
#include "client/history_picture.h"
#include "client/history_stream.h"
#include "client/history_text.h"
#include "client/interrupt.h"
#include "client/load_scene.h"
#include "client/outcome.h"
#include "client/private_server.h"
#include "client/progress_display.h"
#include "client/result_folder.h"
#include "client/study.h"
#include "client/study_table.h"
#include "client/submission.h"
#include "client/terminal.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

struct Run {
  SceneSource scene;
  std::string folder;
  SubmitOptions options;
  bool picture = true;
};

/// Stops a job that cannot go on without this process, and waits until it has ended.
v1::Job stop(Connection& connection, const std::string& job_id, InterruptWatch& interrupt) {
  say("stopping; what was recorded is kept. Ctrl-C again leaves at once");
  interrupt.acknowledge();
  v1::CancelJobRequest request;
  request.set_job_id(job_id);
  request.set_reason("interrupted");
  v1::Job job = connection.call(&v1::Jobs::Stub::CancelJob, request);
  if (has_ended(job.state())) return job;
  QuietListener listener;
  return follow_job(connection, job_id, job.last_sequence(), interrupt, listener);
}

/// Histories as CSV and as a picture beside the result file. Returns their paths.
std::vector<std::string> write_histories(Connection& connection, const v1::Job& job, const fs::path& folder,
                                         bool picture) {
  HistoryRequest request;
  request.job_id = job.job_id();
  const History history = read_history(connection, request);
  const fs::path table = folder / "history.csv";
  std::ofstream out(table);
  write_history_csv(out, history);
  if (!out.flush()) throw CommandError(ExitCode::local_failure, "cannot write " + table.string());
  std::vector<std::string> files{table.string()};
  constexpr std::size_t fewest_rows = 2;  // a run that failed at once has the initial state alone
  if (!picture || history.time.size() < fewest_rows) return files;
  try {
    const fs::path drawing = folder / "history.png";
    draw_histories(select_measured(history, job), picture_notes(job), drawing);
    files.push_back(drawing.string());
  } catch (const CommandError& error) {
    say(fmt::format("no picture: {}", error.what()));  // a missing renderer does not spoil the run
  }
  return files;
}

/// The results in a folder on this machine. Returns their paths; none if nothing was recorded.
std::vector<std::string> bring_back(Connection& connection, const v1::Job& job, const Run& asked,
                                    InterruptWatch& interrupt) {
  if (!job.has_result()) return {};
  const fs::path folder = result_folder(job, asked.folder);
  std::vector<std::string> files = fetch_results(connection, job, folder, &interrupt);
  v1::GetJobRequest request;
  request.set_job_id(job.job_id());
  request.set_with_scene(true);
  const v1::Job with_scene = connection.call(&v1::Jobs::Stub::GetJob, request);
  for (std::string& file : write_histories(connection, with_scene, folder, asked.picture)) {
    files.push_back(std::move(file));
  }
  return files;
}

ExitCode report_stopped(const v1::Job& job, const std::vector<std::string>& files) {
  if (files.empty()) {
    say("stopped before anything was recorded");
  } else {
    say(fmt::format("stopped at time {:.6g} of {:.6g}: these results are incomplete", job.progress().time(),
                    job.progress().end_time()));
  }
  for (const std::string& file : files) std::cout << file << '\n';
  say("to detach from jobs and come back, start a server: trajan serve");
  return ExitCode::detached;
}

ExitCode run(const GlobalOptions& global, const Run& asked) {
  InterruptWatch interrupt;
  const LoadedScene scene = load_scene(asked.scene);
  if (!scene.text.has_structure()) fail_for_mistakes(scene, {});
  AvailableServer server(global.server);
  Connection& connection = server.connection();
  const std::string job_id = submit_scene(connection, scene, asked.options).job_id();
  if (!server.is_private()) say("job " + job_id);
  v1::Job job;
  {
    ProgressDisplay display(is_terminal());
    job = follow_job(connection, job_id, 0, interrupt, display);
  }
  if (!has_ended(job.state()) && !server.is_private()) {
    say(fmt::format("detached; the job goes on. Resume with: trajan watch {0}; trajan fetch {0}", job_id));
    return ExitCode::detached;
  }
  if (!has_ended(job.state())) job = stop(connection, job_id, interrupt);
  const std::vector<std::string> files = bring_back(connection, job, asked, interrupt);
  if (job.state() == v1::CANCELLED && server.is_private()) return report_stopped(job, files);
  if (job.has_study()) print_answer(std::cout, read_study(connection, job_id));
  const ExitCode code = report_outcome(job);
  if (!files.empty() && !job.measures().empty()) std::cout << '\n';
  for (const std::string& file : files) std::cout << file << '\n';
  return code;
}

}  // namespace

void declare_run(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<Run>();
  add_scene_options(app, asked->scene);
  app.add_option("-O,--directory", asked->folder, "Where to put the results (default: <scene>-<job>)")
      ->type_name("DIR");
  app.add_option("--label", asked->options.labels, "A label of the job; may be repeated")
      ->type_name("KEY=VALUE")
      ->take_all();
  app.add_option("--priority", asked->options.priority, "Higher runs earlier")->check(CLI::Range(-100, 100));
  add_fidelity_options(app, asked->options.fidelity);
  app.add_flag("--picture,!--no-picture", asked->picture, "Draw the measured histories (default: yes)");
  app.footer("Uses the configured server, or the default one if it runs, or a private one for this run alone.");
  set_action(app, global, action, asked, run);
}

}  // namespace trajan::client
