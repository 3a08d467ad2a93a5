#include "server/store_studies.h"

#include "server/errors.h"
#include "server/scene_digest.h"
#include "server/store_answers.h"
#include "server/store_estimates.h"
#include "server/store_findings.h"
#include "server/store_jobs.h"
#include "server/store_requests.h"
#include "server/study_table.h"

namespace trajan::store {

namespace {

/// Returns its number.
std::int64_t insert_run(Database& database, const v1::Job& study, const PlannedRun& planned, bool reuse) {
  v1::SubmitJobRequest request;
  *request.mutable_scene() = planned.scene;
  request.set_priority(study.priority());
  v1::Job job =
      insert_job(database, {"", study.priority(), deterministic_bytes(request), {}, planned.scene.name(), false});
  const std::int64_t number = job_number(job.job_id());
  job.set_parent_id(study.job_id());
  *job.mutable_settings() = settings_of(planned.scene);
  Statement plan = database.prepare("UPDATE jobs SET parent = ?, plan = ?, reuse = ?, scene = ? WHERE job_id = ?");
  plan.bind(1, job_number(study.job_id()))
      .bind_blob(2, planned.run.SerializeAsString())
      .bind(3, reuse ? 1 : 0)
      .bind(4, scene_digest(planned.scene))
      .bind(5, number)
      .run();
  keep_estimate(database, job.job_id(), planned.scene, planned.estimate);
  update(database, job);
  return number;
}

v1::Run read_run(Statement& query) {
  v1::Job job;
  job.ParseFromString(query.text(0));
  v1::Run run;
  run.ParseFromString(query.text(1));
  run.set_job_id(job.job_id());
  run.set_state(job.state());
  *run.mutable_measures() = job.measures();
  if (job.has_cost()) *run.mutable_cost() = job.cost();
  run.set_answered_by(job.answered_by());
  if (job.has_failure()) *run.mutable_failure() = job.failure();
  *run.mutable_warnings() = job.warnings();
  return run;
}

v1::StudyProgress count_runs(Database& database, std::int64_t study, const std::string& kind) {
  v1::StudyProgress counts;
  counts.set_kind(kind);
  Statement query = database.prepare("SELECT state, COUNT(*) FROM jobs WHERE parent = ? GROUP BY state");
  query.bind(1, study);
  while (query.step()) {
    const auto count = static_cast<std::int32_t>(query.integer(1));
    counts.set_runs(counts.runs() + count);
    switch (static_cast<v1::JobState>(query.integer(0))) {
      case v1::RUNNING:
      case v1::CANCELLING:
        counts.set_running(counts.running() + count);
        break;
      case v1::SUCCEEDED:
        counts.set_succeeded(count);
        break;
      case v1::FAILED:
        counts.set_failed(count);
        break;
      case v1::CANCELLED:
        counts.set_cancelled(count);
        break;
      default:
        break;
    }
  }
  return counts;
}

v1::JobState state_after(const v1::Job& job) {
  const v1::StudyProgress& counts = job.study();
  const int ended = counts.succeeded() + counts.failed() + counts.cancelled();
  if (ended < counts.runs())
    return job.state() == v1::QUEUED && ended + counts.running() > 0 ? v1::RUNNING : job.state();
  if (job.state() == v1::CANCELLING) return v1::CANCELLED;
  // What follows from the runs of a target is decided elsewhere.
  if (counts.kind() == "target") return job.state();
  // A setting that does not work is an answer of a tradeoff.
  const bool failed = counts.failed() > 0 && (counts.kind() != "tradeoff" || counts.succeeded() == 0);
  if (failed) return v1::FAILED;
  return counts.cancelled() > 0 ? v1::CANCELLED : v1::SUCCEEDED;
}

void append_progress(Database& database, v1::Job& job) {
  const v1::StudyProgress& counts = job.study();
  // How many runs a target takes is not known; it tells what each gave.
  if (counts.kind() == "target") return;
  const int ended = counts.succeeded() + counts.failed() + counts.cancelled();
  v1::Progress& progress = *job.mutable_progress();
  if (progress.step() == ended && progress.total_steps() == counts.runs()) return;
  progress.set_step(ended);
  progress.set_total_steps(counts.runs());
  progress.set_time(ended);
  progress.set_end_time(counts.runs());
  v1::Event event;
  *event.mutable_progress() = progress;
  append_event(database, job, std::move(event));
}

void say_why(v1::Job& job) {
  v1::Failure& failure = *job.mutable_failure();
  failure.set_reason("RUNS_FAILED");
  failure.set_message(std::to_string(job.study().failed()) + " of " + std::to_string(job.study().runs()) +
                      " runs failed");
  failure.set_remedy("look at the runs in the study's table; it has the others' answers");
  failure.set_particle(-1);
}

void read_plan(Database& database, std::int64_t number, v1::Study& study) {
  Statement query = database.prepare("SELECT plan FROM jobs WHERE job_id = ? AND is_study");
  if (!query.bind(1, number).step()) {
    throw ServiceError(grpc::StatusCode::FAILED_PRECONDITION, "NOT_A_STUDY",
                       "job " + std::to_string(number) + " is not a study");
  }
  study.ParseFromString(query.text(0));
}

void write_plan(Database& database, std::int64_t number, const v1::Study& plan) {
  database.prepare("UPDATE jobs SET plan = ? WHERE job_id = ?")
      .bind_blob(1, plan.SerializeAsString())
      .bind(2, number)
      .run();
}

v1::Job submit(Database& database, const NewJob& row, const StudyPlan& plan, bool reuse) {
  require_valid(row);
  if (auto before = submitted_before(database, row)) return get_job(database, job_number(before->job_id()));
  require_room(database, std::ssize(plan.runs));
  v1::Job study = insert_job(database, row);
  study.mutable_study()->set_kind(plan.kind);
  study.mutable_study()->set_runs(static_cast<int>(plan.runs.size()));
  const std::int64_t number = job_number(study.job_id());
  write_plan(database, number, plan.study);
  update(database, study);
  for (const PlannedRun& run : plan.runs) insert_run(database, study, run, reuse);
  for (const std::int64_t run : runs_of(database, number)) take_over_answer(database, run);
  return get_job(database, number);
}

/// The study becomes what its run is to those who look for measures and files.
void take_over(Database& database, v1::Job& study, const v1::Job& run) {
  *study.mutable_measures() = run.measures();
  *study.mutable_result() = run.result();
  *study.mutable_settings() = run.settings();
  add_warnings(database, study, run.warnings());
  study.set_answered_by(run.answered_by().empty() ? run.job_id() : run.answered_by());
  database.prepare("UPDATE jobs SET answered_by = ? WHERE job_id = ?")
      .bind(1, job_number(study.answered_by()))
      .bind(2, job_number(study.job_id()))
      .run();
}

/// What a target says of its method's runs: how far the coarser ones were off, and the band of the one that
/// answers.
void keep_findings_of_target(Database& database, const v1::Study& study) {
  if (!study.answer().has_band()) return;
  v1::Convergence convergence;
  convergence.set_measure(study.target().measure());
  convergence.set_band(study.answer().band());
  convergence.set_extrapolated(study.answer().value());
  v1::Study ladder;
  const std::string& method = study.runs(study.answer().run()).settings(0);
  for (const v1::Run& run : study.runs()) {
    const v1::MeasureValue* value = find_measure(run, study.target().measure());
    if (value == nullptr || run.settings(0) != method) continue;
    *ladder.add_runs() = run;
    convergence.add_values(value->value());
  }
  *ladder.add_convergences() = convergence;
  keep_findings(database, ladder);
}

}  // namespace

v1::Job submit_study(Database& database, const v1::SubmitStudyRequest& request, const StudyPlan& plan) {
  const NewJob row{request.request_id(), request.priority(),     deterministic_bytes(request),
                   request.labels(),     request.scene().name(), true};
  return submit(database, row, plan, !request.run_all());
}

v1::Job submit_target(Database& database, const v1::SubmitJobRequest& request, const StudyPlan& plan) {
  const NewJob row{request.request_id(), request.priority(),     deterministic_bytes(request),
                   request.labels(),     request.scene().name(), true};
  return submit(database, row, plan, true);
}

void add_run(Database& database, std::int64_t number, const PlannedRun& run, int runs_before,
             const std::string& message) {
  v1::Job study = get_job(database, number);
  const bool is_open = study.state() == v1::QUEUED || study.state() == v1::RUNNING;
  if (!is_open || study.study().runs() != runs_before) return;
  study.mutable_study()->set_runs(runs_before + 1);
  if (!message.empty()) append_message(database, study, message);
  update(database, study);
  take_over_answer(database, insert_run(database, study, run, true));
}

void conclude(Database& database, std::int64_t number, const std::optional<v1::Answer>& answer,
              const std::string& message) {
  v1::Job study = get_job(database, number);
  if (study.state() != v1::QUEUED && study.state() != v1::RUNNING) return;
  v1::Study plan;
  read_plan(database, number, plan);
  if (answer) *plan.mutable_answer() = *answer;
  write_plan(database, number, plan);
  append_message(database, study, message);
  if (answer) study.mutable_cost()->set_core_seconds(answer->core_seconds());
  if (answer && answer->reached()) {
    const v1::Study table = get_study(database, number);
    take_over(database, study, get_job(database, job_number(table.runs(answer->run()).job_id())));
    enter(database, study, v1::SUCCEEDED);
  } else {
    v1::Failure& failure = *study.mutable_failure();
    failure.set_reason("TOLERANCE_NOT_REACHED");
    failure.set_message(message);
    failure.set_remedy("look at the runs in its table; allow a larger budget or a larger tolerance");
    failure.set_particle(-1);
    enter(database, study, v1::FAILED);
  }
  update(database, study);
  keep_findings_of_target(database, get_study(database, number));
}

v1::Study get_study(Database& database, std::int64_t number) {
  v1::Study study;
  const v1::Job job = get_job(database, number);
  read_plan(database, number, study);
  *study.mutable_job() = job;
  Statement query = database.prepare("SELECT job, plan FROM jobs WHERE parent = ? ORDER BY job_id");
  query.bind(1, number);
  while (query.step()) *study.add_runs() = read_run(query);
  derive(study, get_scene(database, number));
  return study;
}

std::vector<std::int64_t> runs_of(Database& database, std::int64_t study) {
  Statement query = database.prepare("SELECT job_id FROM jobs WHERE parent = ? ORDER BY job_id");
  query.bind(1, study);
  std::vector<std::int64_t> runs;
  while (query.step()) runs.push_back(query.integer(0));
  return runs;
}

void follow_runs(Database& database, std::int64_t number) {
  v1::Job job = get_job(database, number);
  if (has_ended(job.state())) return;
  // While a study is being queued it has fewer runs than it will have.
  const v1::StudyProgress counts = count_runs(database, number, job.study().kind());
  if (counts.runs() < job.study().runs()) return;
  const bool changed = counts.SerializeAsString() != job.study().SerializeAsString();
  *job.mutable_study() = counts;
  const v1::JobState state = state_after(job);
  if (!changed && state == job.state()) return;
  append_progress(database, job);
  if (state == v1::FAILED) say_why(job);
  if (state != job.state()) enter(database, job, state);
  update(database, job);
  if (has_ended(state)) keep_findings(database, get_study(database, number));
}

std::vector<std::int64_t> open_studies(Database& database) {
  Statement query = database.prepare("SELECT job_id FROM jobs WHERE is_study AND state IN (1, 2, 3)");
  std::vector<std::int64_t> studies;
  while (query.step()) studies.push_back(query.integer(0));
  return studies;
}

}  // namespace trajan::store
