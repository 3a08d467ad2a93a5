#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>

#include "client/commands/all.h"
#include "client/follow_job.h"
#include "client/history_picture.h"
#include "client/history_stream.h"
#include "client/interrupt.h"
#include "client/load_scene.h"
#include "client/outcome.h"
#include "client/private_server.h"
#include "client/progress_display.h"
#include "client/result_folder.h"
#include "client/submission.h"
#include "client/terminal.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

struct Run {
  std::string scene;
  std::string folder;
  SubmitOptions options;
  bool picture = true;
};

/// An interrupted run: on a private server the job cannot go on, elsewhere it does.
ExitCode detach(Connection& connection, const std::string& job_id, bool is_private) {
  if (!is_private) {
    say(fmt::format("detached; the job goes on. Resume with: trajan watch {0}; trajan fetch {0}", job_id));
    return ExitCode::detached;
  }
  v1::CancelJobRequest request;
  request.set_job_id(job_id);
  request.set_reason("interrupted");
  connection.call(&v1::Jobs::Stub::CancelJob, request);
  say("stopped. To detach from jobs and come back, start a server: trajan serve");
  return ExitCode::detached;
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
  if (!picture) return files;
  try {
    const fs::path drawing = folder / "history.png";
    draw_histories(select_measured(history, job), picture_notes(job), drawing);
    files.push_back(drawing.string());
  } catch (const CommandError& error) {
    say(fmt::format("no picture: {}", error.what()));  // a missing renderer does not spoil the run
  }
  return files;
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
  if (!has_ended(job.state())) return detach(connection, job_id, server.is_private());
  std::vector<std::string> files;
  if (job.has_result()) {
    const fs::path folder = result_folder(job, asked.folder);
    files = fetch_results(connection, job, folder, &interrupt);
    v1::GetJobRequest request;
    request.set_job_id(job_id);
    request.set_with_scene(true);
    const v1::Job with_scene = connection.call(&v1::Jobs::Stub::GetJob, request);
    for (std::string& file : write_histories(connection, with_scene, folder, asked.picture)) {
      files.push_back(std::move(file));
    }
  }
  const ExitCode code = report_outcome(job);
  if (!files.empty() && !job.measures().empty()) std::cout << '\n';
  for (const std::string& file : files) std::cout << file << '\n';
  return code;
}

}  // namespace

void declare_run(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<Run>();
  app.add_option("scene", asked->scene, "A scene file, - for standard input, or a gallery scene")->required();
  app.add_option("-O,--directory", asked->folder, "Where to put the results (default: <scene>-<job>)")
      ->type_name("DIR");
  app.add_option("--label", asked->options.labels, "A label of the job; may be repeated")
      ->type_name("KEY=VALUE")
      ->take_all();
  app.add_option("--priority", asked->options.priority, "Higher runs earlier")->check(CLI::Range(-100, 100));
  app.add_flag("--picture,!--no-picture", asked->picture, "Draw the measured histories (default: yes)");
  app.footer("Uses the configured server, or the default one if it runs, or a private one for this run alone.");
  set_action(app, global, action, asked, run);
}

}  // namespace trajan::client
