#pragma once

#include "server/schedule.h"
#include "trajan/v1/worker.grpc.pb.h"

namespace trajan {

/// The workers' protocol on top of the scheduler.
class WorkersService final : public v1::Workers::CallbackService {
 public:
  explicit WorkersService(Scheduler& scheduler) : scheduler_(scheduler) {}

  grpc::ServerUnaryReactor* Lease(grpc::CallbackServerContext* context, const v1::LeaseRequest* request,
                                  v1::LeaseResponse* response) override;
  grpc::ServerUnaryReactor* Report(grpc::CallbackServerContext* context, const v1::ReportRequest* request,
                                   v1::ReportResponse* response) override;
  grpc::ServerUnaryReactor* Complete(grpc::CallbackServerContext* context, const v1::CompleteRequest* request,
                                     v1::CompleteResponse* response) override;

 private:
  Scheduler& scheduler_;
};

}  // namespace trajan
