#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "client/commands/all.h"
#include "client/history_picture.h"
#include "client/study.h"
#include "client/trade_picture.h"
#include "proto/suggestion.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

struct Plot {
  std::string source;
  std::vector<std::string> columns;
  std::string picture;
  bool spectrum = false;
};

/// A column of a history has this name, or it is a dotted prefix.
bool matches(const std::string& column, const std::string& name) {
  return column == name || column.starts_with(name + ".");
}

History select(const History& history, const std::vector<std::string>& names) {
  History selected;
  selected.time = history.time;
  for (const std::string& name : names) {
    bool any = false;
    for (std::size_t i = 0; i < history.columns.size(); ++i) {
      if (!matches(history.columns[i], name)) continue;
      any = true;
      selected.columns.push_back(history.columns[i]);
      selected.values.push_back(history.values[i]);
    }
    if (!any) {
      throw CommandError(ExitCode::not_found, fmt::format("there is no column \"{}\"", name),
                         suggest(name, history.columns, "the columns are"));
    }
  }
  return selected;
}

struct Drawing {
  History history;
  PictureNotes notes;
};

Drawing read_job(const GlobalOptions& global, const Plot& asked) {
  Connection connection = connect(global);
  v1::GetJobRequest request;
  request.set_job_id(resolve_job(connection, asked.source));
  request.set_with_scene(true);
  const v1::Job job = connection.call(&v1::Jobs::Stub::GetJob, request);
  HistoryRequest columns;
  columns.job_id = job.job_id();
  const History history = read_history(connection, columns);
  return {asked.columns.empty() ? select_measured(history, job) : select(history, asked.columns),
          picture_notes(job)};
}

Drawing read_file(const Plot& asked) {
  History history = read_history_csv(asked.source);
  return {asked.columns.empty() ? std::move(history) : select(history, asked.columns), {}};
}

/// The picture of a tradeoff, if the source is a study; false if it is a job.
bool plot_study(const GlobalOptions& global, const Plot& asked) {
  Connection connection = connect(global);
  v1::GetJobRequest request;
  request.set_job_id(resolve_job(connection, asked.source));
  const v1::Job job = connection.call(&v1::Jobs::Stub::GetJob, request);
  if (!job.has_study() || job.study().kind() == "target") return false;
  if (job.study().kind() != "tradeoff")
    throw CommandError(ExitCode::usage, "of studies only tradeoffs and targets have a picture",
                       "plot one of its runs");
  const std::string picture = asked.picture.empty() ? asked.source + "-tradeoff.png" : asked.picture;
  draw_trade(read_study(connection, job.job_id()), picture);
  std::cout << picture << '\n';
  return true;
}

ExitCode plot(const GlobalOptions& global, const Plot& asked) {
  const bool is_file = fs::path(asked.source).extension() == ".csv";
  if (!is_file && plot_study(global, asked)) return ExitCode::success;
  const Drawing drawing = is_file ? read_file(asked) : read_job(global, asked);
  const std::string stem = is_file ? fs::path(asked.source).stem().string() : asked.source;
  const std::string picture =
      asked.picture.empty() ? stem + (asked.spectrum ? "-spectrum.png" : "-history.png") : asked.picture;
  if (asked.spectrum) {
    draw_spectra(drawing.history, drawing.notes, picture);
  } else {
    draw_histories(drawing.history, drawing.notes, picture);
  }
  std::cout << picture << '\n';
  return ExitCode::success;
}

}  // namespace

void declare_plot(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<Plot>();
  app.add_option("source", asked->source, "A job's or a tradeoff's id, last, or a .csv file of `trajan history`")
      ->required();
  app.add_option("columns", asked->columns, "Names or prefixes of columns (default: what the measures are about)");
  app.add_flag("--spectrum", asked->spectrum, "Draw amplitudes over frequency instead");
  app.add_option("-O,--picture", asked->picture, "The picture: .png, .svg or .pdf (default: <job>-history.png)")
      ->type_name("FILE");
  set_action(app, global, action, asked, plot);
}

}  // namespace trajan::client
