#include "server/jobs_service.h"

#include "server/check_scene.h"
#include "server/convert.h"
#include "server/errors.h"
#include "server/fidelity.h"
#include "server/history_stream.h"
#include "server/log.h"
#include "server/refused_stream.h"
#include "server/result_stream.h"
#include "server/run_cost.h"
#include "server/scene_digest.h"
#include "server/status.h"
#include "server/store_estimates.h"
#include "server/store_findings.h"
#include "server/store_jobs.h"
#include "server/store_studies.h"
#include "server/study_target.h"
#include "server/watch_stream.h"

namespace trajan {

namespace {

void check_scene(const v1::Scene& scene, v1::CheckSceneResponse& response) {
  try {
    const Model model = validate(to_scene(scene));
    *response.mutable_plan() = to_proto(plan(model));
    response.mutable_plan()->set_result_bytes(result_bytes(model));
  } catch (const InvalidScene& invalid) {
    *response.mutable_violations() = to_proto(invalid.violations());
  }
}

}  // namespace

JobsService::JobsService(store::Store& store, Hub& hub, Scheduler& scheduler, Targets& targets,
                         const Estimator& estimator, std::filesystem::path jobs_directory)
    : store_(store),
      hub_(hub),
      scheduler_(scheduler),
      targets_(targets),
      estimator_(estimator),
      jobs_directory_(std::move(jobs_directory)) {}

grpc::ServerUnaryReactor* JobsService::CheckScene(grpc::CallbackServerContext* context,
                                                  const v1::CheckSceneRequest* request,
                                                  v1::CheckSceneResponse* response) {
  auto* reactor = context->DefaultReactor();
  checks_.post([=] { answer(*context, *reactor, [&] { check_scene(request->scene(), *response); }); });
  return reactor;
}

std::shared_ptr<store::StudyPlan> JobsService::prepare(v1::SubmitJobRequest& request) {
  if (draining_) throw ServiceError(grpc::StatusCode::UNAVAILABLE, "DRAINING", "the server is shutting down");
  if (!request.fidelity().has_target()) {
    resolve_fidelity(request.fidelity(), *request.mutable_scene());
    return nullptr;
  }
  const auto known = store_.read([&](store::Database& database) {
    return store::findings(database, family_digest(request.scene()), machine_name());
  });
  auto plan = std::make_shared<store::StudyPlan>(plan_target(request, known));
  for (store::PlannedRun& run : plan->runs)
    run.estimate = estimator_.estimate(run.scene, require_valid(run.scene), request.priority());
  return plan;
}

void JobsService::submitted(const v1::Job& job) {
  logging::info("job submitted", {{"job", job.job_id()}, {"scene", job.scene_name()}});
  if (job.has_study()) targets_.look_at(store::job_number(job.job_id()));
  scheduler_.assign();
}

grpc::ServerUnaryReactor* JobsService::SubmitJob(grpc::CallbackServerContext* context,
                                                 const v1::SubmitJobRequest* asked, v1::Job* response) {
  auto* reactor = context->DefaultReactor();
  checks_.post([=, this, request = std::make_shared<v1::SubmitJobRequest>(*asked)] {
    try {
      const auto target = prepare(*request);
      const v1::Estimate estimate =
          target ? v1::Estimate()
                 : estimator_.estimate(request->scene(), require_valid(request->scene()), request->priority());
      store_.commit(
          [=](store::Database& database) {
            *response =
                target ? store::submit_target(database, *request, *target) : store::submit(database, *request);
            if (!target) store::keep_estimate(database, response->job_id(), request->scene(), estimate);
          },
          [=, this](std::exception_ptr error) {
            if (!error) submitted(*response);
            reactor->Finish(to_status(*context, error));
          });
    } catch (...) {
      reactor->Finish(to_status(*context, std::current_exception()));
    }
  });
  return reactor;
}

grpc::ServerUnaryReactor* JobsService::GetJob(grpc::CallbackServerContext* context,
                                              const v1::GetJobRequest* request, v1::Job* response) {
  auto* reactor = context->DefaultReactor();
  readers_.post([=, this] {
    answer(*context, *reactor, [&] {
      const std::int64_t job = store::job_number(request->job_id());
      store_.read([&](store::Database& database) {
        *response = store::get_job(database, job);
        if (request->with_scene()) *response->mutable_scene() = store::get_scene(database, job);
      });
    });
  });
  return reactor;
}

grpc::ServerUnaryReactor* JobsService::ListJobs(grpc::CallbackServerContext* context,
                                                const v1::ListJobsRequest* request,
                                                v1::ListJobsResponse* response) {
  auto* reactor = context->DefaultReactor();
  readers_.post([=, this] {
    answer(*context, *reactor, [&] {
      *response = store_.read([&](store::Database& database) { return store::list_jobs(database, *request); });
    });
  });
  return reactor;
}

grpc::ServerUnaryReactor* JobsService::CancelJob(grpc::CallbackServerContext* context,
                                                 const v1::CancelJobRequest* request, v1::Job* response) {
  auto* reactor = context->DefaultReactor();
  auto runs = std::make_shared<std::vector<std::int64_t>>();
  store_.commit(
      [=](store::Database& database) {
        const std::int64_t job = store::job_number(request->job_id());
        *response = store::cancel(database, job, request->reason());
        *runs = store::runs_of(database, job);
        runs->push_back(job);
      },
      [=, this](std::exception_ptr error) {
        if (!error && response->state() != v1::SUCCEEDED) {
          for (const std::int64_t job : *runs) {
            scheduler_.cancel(job);
            hub_.publish(job);
          }
          if (!response->parent_id().empty()) targets_.look_at(store::job_number(response->parent_id()));
        }
        reactor->Finish(to_status(*context, error));
      });
  return reactor;
}

grpc::ServerUnaryReactor* JobsService::DeleteJob(grpc::CallbackServerContext* context,
                                                 const v1::DeleteJobRequest* request, v1::DeleteJobResponse*) {
  auto* reactor = context->DefaultReactor();
  checks_.post([=, this] {
    answer(*context, *reactor, [&] {
      const std::int64_t job = store::job_number(request->job_id());
      std::vector<std::int64_t> removed;
      store_.commit([&](store::Database& database) { removed = store::remove_job(database, job); });
      for (const std::int64_t each : removed) {
        std::filesystem::remove_all(jobs_directory_ / std::to_string(each));
        hub_.publish(each);
      }
    });
  });
  return reactor;
}

grpc::ServerWriteReactor<v1::WatchJobResponse>* JobsService::WatchJob(grpc::CallbackServerContext* context,
                                                                      const v1::WatchJobRequest* request) {
  return start_or_refuse<v1::WatchJobResponse>(
      *context, [&] { return watch_job(context, *request, store_, hub_, readers_); });
}

grpc::ServerWriteReactor<v1::StreamHistoryResponse>* JobsService::StreamHistory(
    grpc::CallbackServerContext* context, const v1::StreamHistoryRequest* request) {
  return start_or_refuse<v1::StreamHistoryResponse>(
      *context, [&] { return stream_history(context, *request, store_, hub_, histories_, jobs_directory_); });
}

grpc::ServerWriteReactor<v1::ReadResultResponse>* JobsService::ReadResult(grpc::CallbackServerContext* context,
                                                                          const v1::ReadResultRequest* request) {
  return start_or_refuse<v1::ReadResultResponse>(
      *context, [&] { return read_result(context, *request, store_, hub_, readers_, jobs_directory_); });
}

}  // namespace trajan
