#include "server/workers_service.h"

#include "server/status.h"

namespace trajan {

grpc::ServerUnaryReactor* WorkersService::Lease(grpc::CallbackServerContext* context,
                                                const v1::LeaseRequest* request, v1::LeaseResponse* response) {
  auto* reactor = context->DefaultReactor();
  scheduler_.lease(
      *request, [context] { return context->IsCancelled(); },
      [=](const v1::LeaseResponse& lease, std::exception_ptr error) {
        *response = lease;
        reactor->Finish(to_status(*context, error));
      });
  return reactor;
}

grpc::ServerUnaryReactor* WorkersService::Report(grpc::CallbackServerContext* context,
                                                 const v1::ReportRequest* request, v1::ReportResponse* response) {
  auto* reactor = context->DefaultReactor();
  scheduler_.report(*request, [=](const v1::ReportResponse& answer, std::exception_ptr error) {
    *response = answer;
    reactor->Finish(to_status(*context, error));
  });
  return reactor;
}

grpc::ServerUnaryReactor* WorkersService::Complete(grpc::CallbackServerContext* context,
                                                   const v1::CompleteRequest* request, v1::CompleteResponse*) {
  auto* reactor = context->DefaultReactor();
  scheduler_.complete(*request, [=](std::exception_ptr error) { reactor->Finish(to_status(*context, error)); });
  return reactor;
}

}  // namespace trajan
