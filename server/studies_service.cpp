#include "server/studies_service.h"

#include "server/check_scene.h"
#include "server/errors.h"
#include "server/fidelity.h"
#include "server/log.h"
#include "server/status.h"
#include "server/store_jobs.h"
#include "server/study_plan.h"

namespace trajan {

void StudiesService::submit(const store::StudyPlan& plan, const v1::SubmitStudyRequest& request,
                            v1::Job& response) {
  store_.commit([&](store::Database& database) { response = store::submit_study(database, request, plan); });
  logging::info("study submitted",
                {{"job", response.job_id()}, {"kind", plan.kind}, {"runs", std::to_string(plan.runs.size())}});
  scheduler_.assign();
}

grpc::ServerUnaryReactor* StudiesService::SubmitStudy(grpc::CallbackServerContext* context,
                                                      const v1::SubmitStudyRequest* request, v1::Job* response) {
  auto* reactor = context->DefaultReactor();
  plans_.post([=, this] {
    answer(*context, *reactor, [&] {
      if (draining_) throw ServiceError(grpc::StatusCode::UNAVAILABLE, "DRAINING", "the server is shutting down");
      if (request->fidelity().has_target())
        throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "TARGET",
                           "a study has no target; submit the scene with it as a job");
      v1::SubmitStudyRequest study = *request;
      resolve_fidelity(study.fidelity(), *study.mutable_scene());
      store::StudyPlan plan = plan_study(study);
      for (store::PlannedRun& run : plan.runs)
        run.estimate = estimator_.estimate(run.scene, require_valid(run.scene), study.priority());
      submit(plan, study, *response);
    });
  });
  return reactor;
}

grpc::ServerUnaryReactor* StudiesService::GetStudy(grpc::CallbackServerContext* context,
                                                   const v1::GetStudyRequest* request, v1::Study* response) {
  auto* reactor = context->DefaultReactor();
  readers_.post([=, this] {
    answer(*context, *reactor, [&] {
      const std::int64_t study = store::job_number(request->job_id());
      *response = store_.read([&](store::Database& database) { return store::get_study(database, study); });
    });
  });
  return reactor;
}

}  // namespace trajan
