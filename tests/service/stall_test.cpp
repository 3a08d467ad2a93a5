#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/service/service.h"

namespace trajan::test {
namespace {

// A sanitizer keeps freed memory for a while.
#ifdef TRAJAN_SANITIZED
constexpr bool memory_tells = false;
#else
constexpr bool memory_tells = true;
#endif

/// Resident memory in KiB.
std::int64_t resident_memory(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/status");
  std::string word;
  while (file >> word) {
    if (word == "VmRSS:") {
      std::int64_t size = 0;
      file >> size;
      return size;
    }
  }
  return 0;
}

/// A client that opens streams and never reads.
class Stalled {
 public:
  Stalled(Service& service, const std::string& job) {
    v1::StreamHistoryRequest history;
    history.set_job_id(job);
    history.set_follow(true);
    v1::WatchJobRequest watch;
    watch.set_job_id(job);
    for (int i = 0; i < 8; ++i) {
      contexts_.push_back(std::make_unique<grpc::ClientContext>());
      histories_.push_back(service.jobs().StreamHistory(contexts_.back().get(), history));
      contexts_.push_back(std::make_unique<grpc::ClientContext>());
      watches_.push_back(service.jobs().WatchJob(contexts_.back().get(), watch));
    }
  }
  ~Stalled() {
    for (const auto& context : contexts_) context->TryCancel();
  }

 private:
  std::vector<std::unique_ptr<grpc::ClientContext>> contexts_;
  std::vector<std::unique_ptr<grpc::ClientReader<v1::StreamHistoryResponse>>> histories_;
  std::vector<std::unique_ptr<grpc::ClientReader<v1::WatchJobResponse>>> watches_;
};

/// As little computing as possible for each row.
v1::Scene many_rows(int samples) {
  v1::Scene scene = bar(0.1, samples);
  scene.mutable_domain()->set_cell_size(1);
  return scene;
}

TEST(StalledClients, cost_bounded_memory_and_do_not_keep_a_job_from_ending) {
  Service service;
  // The files' library, the database and gRPC have taken what they need after a first job and its reader.
  service.history(service.submit(many_rows(10'000)), true);
  const std::int64_t before = resident_memory(service.server().id());
  // Where memory tells nothing, 2 MB for each client are enough to stall it.
  const std::string job = service.submit(many_rows(memory_tells ? 100'000 : 20'000));
  const Stalled clients(service, job);
  const v1::Job done = service.wait(job);
  EXPECT_EQ(done.state(), v1::SUCCEEDED) << done.ShortDebugString();
  const std::int64_t grown = resident_memory(service.server().id()) - before;
  // Eight clients were offered 1e5 rows of 13 numbers each, 83 MB in all. Each may cost what one message
  // and the transport's windows hold, and an open file: a few MiB.
  if (memory_tells) {
    EXPECT_LT(grown, 8 * 8 * 1024) << "KiB";
  }
  RecordProperty("grown_kib", std::to_string(grown));
}

}  // namespace
}  // namespace trajan::test
