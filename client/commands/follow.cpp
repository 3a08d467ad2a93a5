// The commands that follow a job: watch, history, fetch.
#include <fmt/format.h>

#include <iostream>
#include <optional>

#include "client/commands/all.h"
#include "client/download.h"
#include "client/follow_job.h"
#include "client/history_stream.h"
#include "client/history_text.h"
#include "client/job_table.h"
#include "client/outcome.h"
#include "client/progress_display.h"
#include "client/result_folder.h"
#include "client/study.h"
#include "client/terminal.h"

namespace trajan::client {
namespace {

struct Watch {
  std::string job;
  std::int64_t after_sequence = 0;
  OutputFormat output = OutputFormat::table;
};

/// Every message as a JSON line on standard output.
class JsonListener : public JobListener {
 public:
  void job(const v1::Job& job) override { std::cout << "{\"job\":" << json_text(job, true) << "}" << std::endl; }
  void event(const v1::Event& event) override {
    std::cout << "{\"event\":" << json_text(event, true) << "}" << std::endl;
  }
  void connection_lost() override {}
};

std::unique_ptr<JobListener> make_listener(OutputFormat output) {
  if (output == OutputFormat::jsonl) return std::make_unique<JsonListener>();
  return std::make_unique<ProgressDisplay>(is_terminal());
}

ExitCode watch(const GlobalOptions& global, const Watch& asked) {
  InterruptWatch interrupt;
  Connection connection = connect(global);
  const std::string job_id = resolve_job(connection, asked.job);
  const auto listener = make_listener(asked.output);
  const v1::Job job = follow_job(connection, job_id, asked.after_sequence, interrupt, *listener);
  if (!has_ended(job.state())) {
    say(fmt::format("detached; the job goes on. Resume with: trajan watch {}", job_id));
    return ExitCode::detached;
  }
  if (asked.output == OutputFormat::jsonl) {
    return job.state() == v1::SUCCEEDED ? ExitCode::success : ExitCode::job_failed;
  }
  return job.has_study() ? report_study(connection, job, OutputFormat::table) : report_outcome(job);
}

struct PrintHistory {
  HistoryRequest request;
  OutputFormat output = OutputFormat::csv;
};

/// Rows as CSV or JSON lines on standard output, each batch flushed so that a pipe sees it at once.
class HistoryPrinter : public HistoryConsumer {
 public:
  HistoryPrinter(OutputFormat format, bool with_heading) : format_(format), with_heading_(with_heading) {}
  void columns(const std::vector<std::string>& names) override {
    text_.emplace(format_, names);
    if (format_ == OutputFormat::csv && with_heading_) std::cout << text_->heading() << std::flush;
  }
  void rows(const HistoryRows& rows) override {
    const std::string_view lines = text_->lines(rows);
    std::cout.write(lines.data(), std::ssize(lines)).flush();
  }

 private:
  OutputFormat format_;
  bool with_heading_;
  std::optional<HistoryText> text_;
};

ExitCode history(const GlobalOptions& global, const PrintHistory& asked) {
  InterruptWatch interrupt;
  Connection connection = connect(global);
  HistoryRequest request = asked.request;
  request.job_id = resolve_job(connection, request.job_id);
  HistoryPrinter printer(asked.output, request.first_row == 0);
  const std::int64_t next = stream_history(connection, request, &interrupt, printer);
  if (!interrupt.interrupted()) return ExitCode::success;
  say(fmt::format("detached. Go on with: trajan history {} --follow --from-row {}", request.job_id, next));
  return ExitCode::detached;
}

struct Fetch {
  std::string job;
  std::string folder;
};

ExitCode fetch(const GlobalOptions& global, const Fetch& asked) {
  InterruptWatch interrupt;
  Connection connection = connect(global);
  v1::GetJobRequest request;
  request.set_job_id(resolve_job(connection, asked.job));
  const v1::Job job = connection.call(&v1::Jobs::Stub::GetJob, request);
  for (const std::string& file : fetch_results(connection, job, result_folder(job, asked.folder), &interrupt)) {
    std::cout << file << '\n';
  }
  return ExitCode::success;
}

}  // namespace

void declare_watch(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<Watch>();
  app.add_option("job", asked->job, "A job's id, or last")->required();
  app.add_option("--after", asked->after_sequence, "Only events after this sequence number")
      ->type_name("SEQUENCE")
      ->check(CLI::NonNegativeNumber);
  add_output_option(app, asked->output, {"table", "jsonl"});
  set_action(app, global, action, asked, watch);
}

void declare_history(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<PrintHistory>();
  app.add_option("job", asked->request.job_id, "A job's id, or last")->required();
  app.add_option("columns", asked->request.columns,
                 "Names or prefixes: tip, tip.displacement.y, energies (default: all)");
  app.add_flag("-f,--follow", asked->request.follow, "Go on with new rows until the job ends");
  app.add_option("--from-row", asked->request.first_row, "Start at this row; after row 0 without the heading")
      ->type_name("ROW")
      ->check(CLI::NonNegativeNumber);
  add_output_option(app, asked->output, {"csv", "jsonl"});
  set_action(app, global, action, asked, history);
}

void declare_fetch(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<Fetch>();
  app.add_option("job", asked->job, "A job's id, or last")->required();
  app.add_option("-O,--directory", asked->folder, "Where to put the files (default: <scene>-<job>)")
      ->type_name("DIR");
  set_action(app, global, action, asked, fetch);
}

}  // namespace trajan::client
