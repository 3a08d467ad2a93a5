#pragma once

#include <atomic>

#include "server/estimator.h"
#include "server/schedule.h"
#include "server/store.h"
#include "server/store_studies.h"
#include "server/task_queue.h"
#include "trajan/v1/studies.grpc.pb.h"

namespace trajan {

/// The public API of studies; see JobsService.
class StudiesService final : public v1::Studies::CallbackService {
 public:
  StudiesService(store::Store& store, Scheduler& scheduler, const Estimator& estimator)
      : store_(store), scheduler_(scheduler), estimator_(estimator) {}

  /// Refuses new studies from now on.
  void drain() { draining_ = true; }

  grpc::ServerUnaryReactor* SubmitStudy(grpc::CallbackServerContext* context,
                                        const v1::SubmitStudyRequest* request, v1::Job* response) override;
  grpc::ServerUnaryReactor* GetStudy(grpc::CallbackServerContext* context, const v1::GetStudyRequest* request,
                                     v1::Study* response) override;

 private:
  void submit(const store::StudyPlan& plan, const v1::SubmitStudyRequest& request, v1::Job& response);

  store::Store& store_;
  Scheduler& scheduler_;
  const Estimator& estimator_;
  std::atomic<bool> draining_ = false;
  TaskQueue plans_{1};    ///< validation of many scenes
  TaskQueue readers_{1};  ///< tables
};

}  // namespace trajan
