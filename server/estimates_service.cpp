#include "server/estimates_service.h"

#include "server/audit.h"
#include "server/check_scene.h"
#include "server/errors.h"
#include "server/status.h"
#include "server/store_estimates.h"
#include "server/store_jobs.h"

namespace trajan {

namespace {

constexpr double longest_probe = 20;
constexpr int default_audit = 1000, largest_audit = 10000;

[[noreturn]] void refuse(const char* reason, const char* message) {
  throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, reason, message);
}

}  // namespace

grpc::ServerUnaryReactor* EstimatesService::EstimateJob(grpc::CallbackServerContext* context,
                                                        const v1::EstimateJobRequest* request,
                                                        v1::Estimate* response) {
  auto* reactor = context->DefaultReactor();
  (request->probe_seconds() > 0 ? trials_ : estimates_).post([=, this] {
    answer(*context, *reactor, [&] {
      const double probe = request->probe_seconds();
      if (!(probe >= 0 && probe <= longest_probe)) refuse("PROBE_SECONDS", "probe_seconds must be 0 to 20");
      *response = estimator_.estimate_in_full(request->scene(), require_valid(request->scene()),
                                              request->priority(), probe);
    });
  });
  return reactor;
}

grpc::ServerUnaryReactor* EstimatesService::GetPrediction(grpc::CallbackServerContext* context,
                                                          const v1::GetPredictionRequest* request,
                                                          v1::Prediction* response) {
  auto* reactor = context->DefaultReactor();
  estimates_.post([=, this] {
    answer(*context, *reactor, [&] {
      const std::int64_t job = store::job_number(request->job_id());
      const auto found =
          store_.read([&](store::Database& database) { return store::find_prediction(database, job); });
      if (!found)
        throw ServiceError(grpc::StatusCode::NOT_FOUND, "NO_PREDICTION",
                           "nothing was estimated of job " + request->job_id());
      *response = *found;
    });
  });
  return reactor;
}

grpc::ServerUnaryReactor* EstimatesService::AuditEstimates(grpc::CallbackServerContext* context,
                                                           const v1::AuditEstimatesRequest* request,
                                                           v1::Audit* response) {
  auto* reactor = context->DefaultReactor();
  estimates_.post([=, this] {
    answer(*context, *reactor, [&] {
      const int most = request->most() == 0 ? default_audit : request->most();
      if (most < 1 || most > largest_audit) refuse("MOST", "most must be 1 to 10000");
      const auto predictions =
          store_.read([&](store::Database& database) { return store::predictions(database, "", most); });
      *response->mutable_coverages() = coverages(predictions);
      response->mutable_predictions()->Assign(predictions.begin(), predictions.end());
    });
  });
  return reactor;
}

}  // namespace trajan
