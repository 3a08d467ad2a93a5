// The commands that make studies of a scene: sweep, study, tradeoff.
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
#include "client/trade_picture.h"

namespace trajan::client {
namespace {

/// What all studies are asked with.
struct StudyOptions {
  SceneSource scene;
  FidelityOptions fidelity;
  std::vector<std::string> labels;
  int priority = 0;
  bool wait = true;
  bool run_all = false;
  OutputFormat output = OutputFormat::table;
  std::string picture;  ///< of a tradeoff; empty: none
};

v1::SubmitStudyRequest request_of(const StudyOptions& options) {
  v1::SubmitStudyRequest request;
  *request.mutable_labels() = parse_labels(options.labels);
  request.set_priority(options.priority);
  request.set_run_all(options.run_all);
  *request.mutable_fidelity() = parse_fidelity(options.fidelity);
  return request;
}

/// A private server dies with this process, and its studies with it.
ExitCode follow_study(AvailableServer& server, const std::string& job_id, const StudyOptions& options) {
  InterruptWatch interrupt;
  v1::Job job;
  {
    ProgressDisplay display(is_terminal());
    job = follow_job(server.connection(), job_id, 0, interrupt, display);
  }
  if (has_ended(job.state())) {
    const ExitCode code = report_study(server.connection(), job, options.output);
    if (!options.picture.empty()) draw_trade(read_study(server.connection(), job_id), options.picture);
    return code;
  }
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
  return follow_study(server, job_id, options);
}

void add_study_options(CLI::App& app, StudyOptions& options) {
  add_scene_options(app, options.scene);
  add_preset_option(app, options.fidelity);
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

struct LadderOptions {
  StudyOptions study;
  v1::Ladder ladder;
};

ExitCode study(const GlobalOptions& global, const LadderOptions& asked) {
  v1::SubmitStudyRequest request = request_of(asked.study);
  *request.mutable_ladder() = asked.ladder;
  return perform_study(global, asked.study, request);
}

struct TradeoffOptions {
  StudyOptions study;
  std::vector<std::string> over;
  std::string measure;
};

ExitCode tradeoff(const GlobalOptions& global, const TradeoffOptions& asked) {
  v1::SubmitStudyRequest request = request_of(asked.study);
  request.mutable_tradeoff()->set_measure(asked.measure);
  for (const std::string& over : asked.over) *request.mutable_tradeoff()->add_dials() = parse_over(over);
  return perform_study(global, asked.study, request);
}

CLI::Option* add_over(CLI::App& app, std::vector<std::string>& over, const char* help) {
  return app.add_option("--over", over, help)
      ->type_name("PATH=VALUES")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

}  // namespace

void declare_study(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<LadderOptions>();
  add_study_options(app, asked->study);
  app.add_option_function<int>(
         "--levels", [asked](int levels) { asked->ladder.set_levels(levels); }, "Cell sizes, 3 to 6 (default: 3)")
      ->check(CLI::Range(3, 6));
  app.add_option_function<double>(
         "--ratio", [asked](double ratio) { asked->ladder.set_ratio(ratio); },
         "Of two neighbouring cell sizes (default: 2)")
      ->check(CLI::Range(1.1, 4.0));
  app.add_option_function<double>(
         "--finest", [asked](double finest) { asked->ladder.set_finest(finest); },
         "The smallest cell size (default: the scene's)")
      ->check(CLI::PositiveNumber);
  app.footer("Says how far each measure is from that of ever smaller cells, or why it cannot say.");
  set_action(app, global, action, asked, study);
}

void declare_tradeoff(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<TradeoffOptions>();
  add_study_options(app, asked->study);
  add_over(app, asked->over,
           "Values of a field as in sweep, instead of the usual dials; repeated: all combinations");
  app.add_option("--measure", asked->measure, "Whose error counts (default: the first with an exact value)");
  app.add_option("--picture", asked->study.picture, "Draw error over core-seconds: .png, .svg or .pdf")
      ->type_name("FILE");
  app.footer("Tries methods and cell sizes; prints the errors, what they took, and the cheapest for a tolerance.");
  set_action(app, global, action, asked, tradeoff);
}

void declare_sweep(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<SweepOptions>();
  add_study_options(app, asked->study);
  add_over(app, asked->over, "Values of a field, v1,v2,... or from:to:count; repeated: all combinations")
      ->required();
  app.footer(
      "As in: trajan sweep cantilever --over domain.cell_size=0.25,0.125 --over numerics.scheme=MUSL,TLMPM");
  set_action(app, global, action, asked, sweep);
}

}  // namespace trajan::client
