#include "server/store_studies.h"

#include "server/errors.h"
#include "server/scene_digest.h"
#include "server/store_answers.h"
#include "server/store_findings.h"
#include "server/store_jobs.h"
#include "server/store_requests.h"
#include "server/study_table.h"

namespace trajan::store {

namespace {

void insert_run(Database& database, const v1::SubmitStudyRequest& study, const v1::Job& parent,
                const PlannedRun& planned) {
  v1::SubmitJobRequest request;
  *request.mutable_scene() = planned.scene;
  request.set_priority(study.priority());
  v1::Job job =
      insert_job(database, {"", study.priority(), deterministic_bytes(request), {}, planned.scene.name(), false});
  const std::int64_t number = job_number(job.job_id());
  job.set_parent_id(parent.job_id());
  Statement plan = database.prepare("UPDATE jobs SET parent = ?, plan = ?, reuse = ?, scene = ? WHERE job_id = ?");
  plan.bind(1, job_number(parent.job_id()))
      .bind_blob(2, planned.run.SerializeAsString())
      .bind(3, study.run_all() ? 0 : 1)
      .bind(4, scene_digest(planned.scene))
      .bind(5, number)
      .run();
  update(database, job);
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
  // A setting that does not work is an answer of a tradeoff.
  const bool failed = counts.failed() > 0 && (counts.kind() != "tradeoff" || counts.succeeded() == 0);
  if (failed) return v1::FAILED;
  return counts.cancelled() > 0 ? v1::CANCELLED : v1::SUCCEEDED;
}

void append_progress(Database& database, v1::Job& job) {
  const v1::StudyProgress& counts = job.study();
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

}  // namespace

v1::Job submit_study(Database& database, const v1::SubmitStudyRequest& request, const StudyPlan& plan) {
  const NewJob row{request.request_id(), request.priority(),     deterministic_bytes(request),
                   request.labels(),     request.scene().name(), true};
  require_valid(row);
  if (auto before = submitted_before(database, row)) return get_job(database, job_number(before->job_id()));
  require_room(database, std::ssize(plan.runs));
  v1::Job study = insert_job(database, row);
  study.mutable_study()->set_kind(plan.kind);
  study.mutable_study()->set_runs(static_cast<int>(plan.runs.size()));
  const std::int64_t number = job_number(study.job_id());
  database.prepare("UPDATE jobs SET plan = ? WHERE job_id = ?")
      .bind_blob(1, plan.study.SerializeAsString())
      .bind(2, number)
      .run();
  update(database, study);
  for (const PlannedRun& run : plan.runs) insert_run(database, request, study, run);
  for (const std::int64_t run : runs_of(database, number)) take_over_answer(database, run);
  return get_job(database, number);
}

v1::Study get_study(Database& database, std::int64_t number) {
  v1::Study study;
  const v1::Job job = get_job(database, number);
  read_plan(database, number, study);
  *study.mutable_job() = job;
  Statement query = database.prepare("SELECT job, plan FROM jobs WHERE parent = ? ORDER BY job_id");
  query.bind(1, number);
  while (query.step()) *study.add_runs() = read_run(query);
  derive(study);
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
  if (counts.SerializeAsString() == job.study().SerializeAsString()) return;
  *job.mutable_study() = counts;
  append_progress(database, job);
  const v1::JobState state = state_after(job);
  if (state == v1::FAILED) say_why(job);
  if (state != job.state()) enter(database, job, state);
  update(database, job);
  if (has_ended(state)) keep_findings(database, get_study(database, number));
}

}  // namespace trajan::store
