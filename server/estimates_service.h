#pragma once

#include "server/estimator.h"
#include "server/task_queue.h"
#include "trajan/v1/estimates.grpc.pb.h"

namespace trajan {

/// The public API of estimates; see JobsService.
class EstimatesService final : public v1::Estimates::CallbackService {
 public:
  EstimatesService(store::Store& store, const Estimator& estimator) : store_(store), estimator_(estimator) {}

  grpc::ServerUnaryReactor* EstimateJob(grpc::CallbackServerContext* context,
                                        const v1::EstimateJobRequest* request, v1::Estimate* response) override;
  grpc::ServerUnaryReactor* GetPrediction(grpc::CallbackServerContext* context,
                                          const v1::GetPredictionRequest* request,
                                          v1::Prediction* response) override;
  grpc::ServerUnaryReactor* AuditEstimates(grpc::CallbackServerContext* context,
                                           const v1::AuditEstimatesRequest* request, v1::Audit* response) override;

 private:
  store::Store& store_;
  const Estimator& estimator_;
  TaskQueue estimates_{1};
  TaskQueue trials_{1};  ///< one at a time: they are to be alone on their core
};

}  // namespace trajan
