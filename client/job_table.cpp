#include "client/job_table.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <google/protobuf/util/json_util.h>

#include <chrono>
#include <cmath>

#include "client/progress_display.h"
#include "client/terminal.h"

namespace trajan::client {
namespace {

double seconds_of(const google::protobuf::Timestamp& time) {
  return static_cast<double>(time.seconds()) + 1e-9 * time.nanos();
}

Cell progress_of(const v1::Job& job) {
  if (job.state() == v1::SUCCEEDED) return std::string("100 %");
  if (!job.has_progress() || job.progress().end_time() <= 0) return {};
  return fmt::format("{:.0f} %", std::floor(100 * job.progress().time() / job.progress().end_time()));
}

Cell time_taken(const v1::Job& job) {
  if (!job.has_started()) return {};
  const double now = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  const double end = job.has_ended() ? seconds_of(job.ended()) : now;
  return duration_for_people(end - seconds_of(job.started()));
}

Cell labels_of(const v1::Job& job) {
  std::string text;
  for (const auto& [key, value] : std::map<std::string, std::string>(job.labels().begin(), job.labels().end())) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", key, value);
  }
  return text.empty() ? Cell() : Cell(text);
}

/// Where the run stands or where it stopped.
std::string place_of(const v1::Job& job) {
  const v1::Progress& progress = job.progress();
  const double share = progress.end_time() > 0 ? 100 * progress.time() / progress.end_time() : 0;
  std::string text = fmt::format("{:.0f} %, time {:.6g} of {:.6g}, step {} of {}", std::floor(share),
                                 progress.time(), progress.end_time(), progress.step(), progress.total_steps());
  if (job.state() != v1::RUNNING) return text;
  if (progress.has_remaining()) {
    text += fmt::format(", {} left", duration_for_people(static_cast<double>(progress.remaining().seconds())));
  }
  return text + fmt::format(", {} particles/s", count_for_people(progress.particle_steps_per_second()));
}

std::string result_of(const v1::ResultFile& result) {
  return fmt::format("{} ({}{})", result.path().empty() ? result.name() : result.path(),
                     bytes_for_people(static_cast<double>(result.size())),
                     result.complete() ? "" : ", incomplete: the run ended early");
}

std::string study_of(const v1::Job& job) {
  const v1::StudyProgress& study = job.study();
  if (!job.has_study()) return {};
  std::string text = fmt::format("{} of {} runs: {} succeeded", study.kind(), study.runs(), study.succeeded());
  if (study.failed() > 0) text += fmt::format(", {} failed", study.failed());
  if (study.cancelled() > 0) text += fmt::format(", {} cancelled", study.cancelled());
  return study.running() == 0 ? text : text + fmt::format(", {} running", study.running());
}

std::string cost_of(const v1::Cost& cost) {
  std::string text = fmt::format("{:.3g} core-seconds", cost.core_seconds());
  if (cost.wall_seconds() > 0) text += fmt::format(", {:.3g} s", cost.wall_seconds());
  if (cost.peak_memory_bytes() > 0)
    text += fmt::format(", {} of memory, {} of them for the job",
                        bytes_for_people(static_cast<double>(cost.peak_memory_bytes())),
                        bytes_for_people(static_cast<double>(cost.memory_bytes())));
  return text;
}

/// "cells of 0.1, 2 particles a side, TLMPM linear FLIP, quasi_static"
std::string settings_text(const v1::Settings& settings) {
  const v1::Numerics& numerics = settings.numerics();
  const auto* kinds = v1::Analysis::descriptor()->FindOneofByName("kind");
  const auto* kind = settings.analysis().GetReflection()->GetOneofFieldDescriptor(settings.analysis(), kinds);
  return fmt::format("cells of {:.6g}, {} particles a side, {} {} {}, {}", settings.cell_size(),
                     settings.particles_per_cell_side(), numerics.scheme(), numerics.shape_functions(),
                     numerics.transfer(), kind == nullptr ? "explicit_dynamics" : kind->name());
}

Cell verdict_of(const v1::MeasureValue& measure) {
  if (!measure.has_error() || !measure.has_tolerance()) return {};
  return std::string(std::abs(measure.error()) <= measure.tolerance() ? "ok" : "off");
}

}  // namespace

std::optional<std::string> time_text(const google::protobuf::Timestamp& time) {
  if (time.seconds() == 0) return std::nullopt;
  return fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::localtime(static_cast<std::time_t>(time.seconds())));
}

Table job_table(std::span<const v1::Job* const> jobs) {
  Table table{{"job", "state", "scene", "progress", "submitted", "took", "labels"}, {}};
  for (const v1::Job* job : jobs) {
    const auto submitted = time_text(job->submitted());
    const std::string what =
        job->has_study() ? fmt::format(" ({} of {})", job->study().kind(), job->study().runs()) : std::string();
    table.rows.push_back({job->job_id(), state_name(job->state()), job->scene_name() + what, progress_of(*job),
                          submitted ? Cell(*submitted) : Cell(), time_taken(*job), labels_of(*job)});
  }
  return table;
}

std::string failure_text(const v1::Failure& failure) {
  std::string text = fmt::format("{}: {}", failure.reason(), failure.message());
  if (failure.step() == 0) return text;
  text += fmt::format(" (step {}, time {:.6g}", failure.step(), failure.time());
  return text + (failure.particle() < 0 ? ")" : fmt::format(", particle {})", failure.particle()));
}

std::string describe_job(const v1::Job& job, const std::string& expectation) {
  std::string text;
  const auto add = [&text](std::string_view name, const std::string& value) {
    if (!value.empty()) text += fmt::format("{:<10} {}\n", name, value);
  };
  const auto cell_text = [](const Cell& cell) {
    const auto* value = std::get_if<std::string>(&cell);
    return value == nullptr ? std::string() : *value;
  };
  add("job", job.job_id());
  add("scene", job.scene_name());
  add("study", study_of(job));
  add("run of", job.parent_id());
  add("state", state_name(job.state()) + (job.attempts() > 1 ? fmt::format(" (attempt {})", job.attempts()) : ""));
  add("answer of", job.answered_by().empty() ? "" : "job " + job.answered_by());
  add("settings", job.has_settings() ? settings_text(job.settings()) : "");
  add("progress", job.has_progress() && !job.has_study() ? place_of(job) : "");
  add("cost", job.has_cost() ? cost_of(job.cost()) : "");
  add("expected", expectation);
  add("labels", cell_text(labels_of(job)));
  add("priority", job.priority() == 0 ? "" : std::to_string(job.priority()));
  add("submitted", time_text(job.submitted()).value_or(""));
  add("started", time_text(job.started()).value_or(""));
  add("ended", time_text(job.ended()).value_or(""));
  add("took", cell_text(time_taken(job)));
  add("failure", job.has_failure() ? failure_text(job.failure()) : "");
  add("remedy", job.failure().remedy());
  for (const v1::Warning& warning : job.warnings())
    add("warning", fmt::format("from time {:.6g} on: {}; {}", warning.time(), warning.cause(), warning.remedy()));
  add("result", job.has_result() ? result_of(job.result()) : "");
  return text;
}

Table measure_table(const v1::Job& job) {
  Table table{{"measure", "value", "exact", "error", "tolerance", "verdict"}, {}};
  for (const v1::MeasureValue& measure : job.measures()) {
    table.rows.push_back({measure.name(), measure.value(), measure.has_exact() ? Cell(measure.exact()) : Cell(),
                          measure.has_error() ? Cell(measure.error()) : Cell(),
                          measure.has_tolerance() ? Cell(measure.tolerance()) : Cell(), verdict_of(measure)});
  }
  return table;
}

std::string json_text(const google::protobuf::Message& message, bool on_one_line) {
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  options.always_print_primitive_fields = true;
  options.add_whitespace = !on_one_line;
  std::string text;
  const auto status = google::protobuf::util::MessageToJsonString(message, &text, options);
  return status.ok() ? text : "null";
}

}  // namespace trajan::client
