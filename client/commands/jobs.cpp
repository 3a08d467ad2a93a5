// The commands about jobs that only ask the server something: submit, ls, show, cancel, rm.
#include <fmt/format.h>
#include <google/protobuf/text_format.h>

#include <iostream>

#include "client/commands/all.h"
#include "client/estimate_table.h"
#include "client/job_table.h"
#include "client/load_scene.h"
#include "client/progress_display.h"
#include "client/study.h"
#include "client/study_table.h"
#include "client/submission.h"
#include "client/terminal.h"
#include "proto/suggestion.h"

namespace trajan::client {
namespace {

struct Submit {
  SceneSource scene;
  SubmitOptions options;
  OutputFormat output = OutputFormat::table;
};

ExitCode submit(const GlobalOptions& global, const Submit& asked) {
  Connection connection = connect(global);
  const LoadedScene scene = load_scene(asked.scene);
  const v1::Job job = submit_scene(connection, scene, asked.options);
  if (asked.output == OutputFormat::table) {
    std::cout << job.job_id() << '\n';
    say(fmt::format("follow it with: trajan watch {}", job.job_id()));
  } else {
    std::cout << json_text(job, asked.output == OutputFormat::jsonl) << '\n';
  }
  return ExitCode::success;
}

struct List {
  std::vector<std::string> states;
  std::vector<std::string> labels;
  std::string study;
  bool runs = false;
  int most = 50;
  OutputFormat output = OutputFormat::table;
};

v1::JobState parse_state(const std::string& name) {
  std::vector<std::string> known;
  for (int i = v1::QUEUED; i <= v1::CANCELLED; ++i) {
    if (state_name(static_cast<v1::JobState>(i)) == name) return static_cast<v1::JobState>(i);
    known.push_back(state_name(static_cast<v1::JobState>(i)));
  }
  throw CommandError(ExitCode::usage, fmt::format("\"{}\" is not a state of jobs", name),
                     suggest(name, known, "the states are"));
}

std::vector<v1::Job> list_jobs(Connection& connection, const List& asked) {
  constexpr int largest_page = 1000;
  v1::ListJobsRequest request;
  for (const std::string& state : asked.states) request.add_states(parse_state(state));
  for (const std::string& label : asked.labels) {
    (*request.mutable_labels())[label.substr(0, label.find('='))] = label.substr(label.find('=') + 1);
  }
  request.set_parent_id(asked.study);
  request.set_with_runs(asked.runs);
  std::vector<v1::Job> jobs;
  do {
    request.set_page_size(std::min(asked.most - static_cast<int>(jobs.size()), largest_page));
    const auto response = connection.call(&v1::Jobs::Stub::ListJobs, request);
    jobs.insert(jobs.end(), response.jobs().begin(), response.jobs().end());
    request.set_page_token(response.next_page_token());
  } while (!request.page_token().empty() && static_cast<int>(jobs.size()) < asked.most);
  return jobs;
}

ExitCode list(const GlobalOptions& global, const List& asked) {
  Connection connection = connect(global);
  const std::vector<v1::Job> jobs = list_jobs(connection, asked);
  if (asked.output == OutputFormat::jsonl) {
    for (const v1::Job& job : jobs) std::cout << json_text(job, true) << '\n';
  } else if (asked.output == OutputFormat::json) {
    v1::ListJobsResponse all;
    all.mutable_jobs()->Assign(jobs.begin(), jobs.end());
    std::cout << json_text(all, false);
  } else {
    std::vector<const v1::Job*> pointers;
    for (const v1::Job& job : jobs) pointers.push_back(&job);
    print_table(std::cout, job_table(pointers), asked.output);
  }
  return ExitCode::success;
}

struct Show {
  std::string job;
  bool scene = false;
  OutputFormat output = OutputFormat::table;
};

void print_study(const v1::Study& study, OutputFormat output) {
  if (output == OutputFormat::table) std::cout << describe_job(study.job()) << '\n';
  print_study_table(std::cout, study, output);
}

/// What was expected of the job; nothing if nobody estimated it.
std::string expectation_of(Connection& connection, const v1::Job& job) {
  v1::GetPredictionRequest request;
  request.set_job_id(job.job_id());
  try {
    return describe_expectation(connection.call(&v1::Estimates::Stub::GetPrediction, request).estimate());
  } catch (const CommandError& error) {
    // A job of an older server, or a server that knows no estimates.
    if (error.code == ExitCode::not_found || error.code == ExitCode::job_failed) return {};
    throw;
  }
}

void print_job(Connection& connection, const v1::Job& job, OutputFormat output) {
  if (output != OutputFormat::table) {
    const v1::Job* pointer = &job;
    return print_table(std::cout, job_table({&pointer, 1}), output);
  }
  std::cout << describe_job(job, expectation_of(connection, job));
  if (job.measures().empty()) return;
  std::cout << '\n';
  print_table(std::cout, measure_table(job), output);
}

ExitCode show(const GlobalOptions& global, const Show& asked) {
  Connection connection = connect(global);
  v1::GetJobRequest request;
  request.set_job_id(resolve_job(connection, asked.job));
  request.set_with_scene(asked.scene);
  const v1::Job job = connection.call(&v1::Jobs::Stub::GetJob, request);
  if (asked.scene) {
    std::string text;
    google::protobuf::TextFormat::PrintToString(job.scene(), &text);
    std::cout << (asked.output == OutputFormat::table
                      ? text
                      : json_text(job.scene(), asked.output == OutputFormat::jsonl) + "\n");
  } else if (job.has_study()) {
    print_study(read_study(connection, job.job_id()), asked.output);
  } else if (asked.output == OutputFormat::json || asked.output == OutputFormat::jsonl) {
    std::cout << json_text(job, asked.output == OutputFormat::jsonl) << '\n';
  } else {
    print_job(connection, job, asked.output);
  }
  return ExitCode::success;
}

struct JobIds {
  std::vector<std::string> jobs;
};

/// Does the same to every job; goes on after a failure and returns the last one's code.
template <typename Act>
ExitCode for_each_job(const GlobalOptions& global, const JobIds& asked, Act act) {
  Connection connection = connect(global);
  ExitCode code = ExitCode::success;
  for (const std::string& name : asked.jobs) {
    try {
      act(connection, resolve_job(connection, name));
    } catch (const CommandError& error) {
      say_error(name + ": " + error.what(), error.hint);
      code = error.code;
    }
  }
  return code;
}

ExitCode cancel(const GlobalOptions& global, const JobIds& asked) {
  return for_each_job(global, asked, [](Connection& connection, const std::string& job_id) {
    v1::CancelJobRequest request;
    request.set_job_id(job_id);
    request.set_reason("trajan cancel");
    say(fmt::format("{}: {}", job_id, state_name(connection.call(&v1::Jobs::Stub::CancelJob, request).state())));
  });
}

ExitCode remove(const GlobalOptions& global, const JobIds& asked) {
  return for_each_job(global, asked, [](Connection& connection, const std::string& job_id) {
    v1::DeleteJobRequest request;
    request.set_job_id(job_id);
    connection.call(&v1::Jobs::Stub::DeleteJob, request);
    say(fmt::format("{}: removed", job_id));
  });
}

}  // namespace

void declare_submit(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<Submit>();
  add_scene_options(app, asked->scene);
  app.add_option("--label", asked->options.labels, "A label of the job; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  app.add_option("--priority", asked->options.priority, "Higher runs earlier")->check(CLI::Range(-100, 100));
  add_fidelity_options(app, asked->options.fidelity);
  app.add_option("--request-id", asked->options.request_id,
                 "The same id never makes a second job (default: random)")
      ->type_name("ID");
  add_output_option(app, asked->output, {"table", "json", "jsonl"});
  set_action(app, global, action, asked, submit);
}

void declare_list(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<List>();
  app.add_option("--state", asked->states, "Only jobs in this state; may be repeated")
      ->type_name("STATE")
      ->take_all();
  app.add_option("--label", asked->labels, "Only jobs with this label; may be repeated")
      ->type_name("KEY=VALUE")
      ->take_all();
  app.add_option("--study", asked->study, "Only the runs of this study")->type_name("JOB");
  app.add_flag("--runs", asked->runs, "The runs of studies as well");
  app.add_option("-n,--most", asked->most, "List at most so many")->check(CLI::PositiveNumber);
  add_output_option(app, asked->output, {"table", "json", "jsonl", "csv"});
  set_action(app, global, action, asked, list);
}

void declare_show(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<Show>();
  app.add_option("job", asked->job, "A job's id, or last")->required();
  app.add_flag("--scene", asked->scene, "Print the scene as it was submitted");
  add_output_option(app, asked->output, {"table", "json", "jsonl", "csv"});
  set_action(app, global, action, asked, show);
}

void declare_cancel(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<JobIds>();
  app.add_option("jobs", asked->jobs, "The jobs' ids, or last")->required();
  set_action(app, global, action, asked, cancel);
}

void declare_remove(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<JobIds>();
  app.add_option("jobs", asked->jobs, "The jobs' ids, or last")->required();
  set_action(app, global, action, asked, remove);
}

}  // namespace trajan::client
