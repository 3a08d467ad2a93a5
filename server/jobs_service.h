#pragma once

#include <atomic>
#include <filesystem>
#include <memory>

#include "server/estimator.h"
#include "server/history_stream.h"
#include "server/hub.h"
#include "server/schedule.h"
#include "server/store.h"
#include "server/store_studies.h"
#include "server/targets.h"
#include "server/task_queue.h"
#include "trajan/v1/jobs.grpc.pb.h"

namespace trajan {

/// The public API. Handlers hand their work to the task queues, the store or the scheduler and return;
/// no thread of gRPC waits for anything.
class JobsService final : public v1::Jobs::CallbackService {
 public:
  JobsService(store::Store& store, Hub& hub, Scheduler& scheduler, Targets& targets, const Estimator& estimator,
              std::filesystem::path jobs_directory);

  /// Refuses new jobs from now on.
  void drain() { draining_ = true; }

  grpc::ServerUnaryReactor* CheckScene(grpc::CallbackServerContext* context, const v1::CheckSceneRequest* request,
                                       v1::CheckSceneResponse* response) override;
  grpc::ServerUnaryReactor* SubmitJob(grpc::CallbackServerContext* context, const v1::SubmitJobRequest* request,
                                      v1::Job* response) override;
  grpc::ServerUnaryReactor* GetJob(grpc::CallbackServerContext* context, const v1::GetJobRequest* request,
                                   v1::Job* response) override;
  grpc::ServerUnaryReactor* ListJobs(grpc::CallbackServerContext* context, const v1::ListJobsRequest* request,
                                     v1::ListJobsResponse* response) override;
  grpc::ServerUnaryReactor* CancelJob(grpc::CallbackServerContext* context, const v1::CancelJobRequest* request,
                                      v1::Job* response) override;
  grpc::ServerUnaryReactor* DeleteJob(grpc::CallbackServerContext* context, const v1::DeleteJobRequest* request,
                                      v1::DeleteJobResponse* response) override;
  grpc::ServerWriteReactor<v1::WatchJobResponse>* WatchJob(grpc::CallbackServerContext* context,
                                                           const v1::WatchJobRequest* request) override;
  grpc::ServerWriteReactor<v1::StreamHistoryResponse>* StreamHistory(
      grpc::CallbackServerContext* context, const v1::StreamHistoryRequest* request) override;
  grpc::ServerWriteReactor<v1::ReadResultResponse>* ReadResult(grpc::CallbackServerContext* context,
                                                               const v1::ReadResultRequest* request) override;

 private:
  /// The plan of a target, or null; the request's scene gets the settings of its fidelity.
  std::shared_ptr<store::StudyPlan> prepare(v1::SubmitJobRequest& request);
  void submitted(const v1::Job& job);

  store::Store& store_;
  Hub& hub_;
  Scheduler& scheduler_;
  Targets& targets_;
  const Estimator& estimator_;
  const std::filesystem::path jobs_directory_;
  std::atomic<bool> draining_ = false;
  TaskQueue checks_{2};   ///< validation of scenes, removal of files
  TaskQueue readers_{2};  ///< short reads of the store and of finished files
  HistoryReading histories_;
};

}  // namespace trajan
