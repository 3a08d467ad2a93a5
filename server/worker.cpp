#include "server/worker.h"

#include <grpcpp/channel.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <signal.h>
#include <unistd.h>

#include <fstream>
#include <random>
#include <sstream>

#include "server/log.h"
#include "server/worker_job.h"

namespace trajan {

namespace {

using Clock = std::chrono::steady_clock;

std::atomic<bool> leaving = false;

/// While the worker lives, SIGTERM and SIGINT only ask it to leave.
class StopSignals {
 public:
  StopSignals() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGTERM);
    sigaddset(&signals_, SIGINT);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    signal(SIGPIPE, SIG_IGN);
    thread_ = std::thread([this] {
      int received = 0;
      sigwait(&signals_, &received);
      leaving = true;
    });
  }
  ~StopSignals() {
    pthread_kill(thread_.native_handle(), SIGTERM);
    thread_.join();
  }
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

 private:
  sigset_t signals_;
  std::thread thread_;
};

std::shared_ptr<grpc::Channel> connect(const std::string& server) {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(-1);
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, 100);
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, 1000);
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 1000);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, 30'000);
  return grpc::CreateCustomChannel(server, grpc::InsecureChannelCredentials(), arguments);
}

class Worker {
 public:
  explicit Worker(const WorkOptions& options)
      : options_(options), channel_(connect(options.server)), server_(v1::Workers::NewStub(channel_)) {
    request_.set_solver_version(TRAJAN_VERSION);
    request_.set_threads(options.threads);
    const bool local = !options.worker_id.empty();
    request_.set_worker_id(local ? options.worker_id : own_id());
    if (local) request_.set_process_id(getpid());
  }

  void work_until_told() {
    while (!leaving) {
      v1::LeaseResponse lease;
      const grpc::Status status = ask(lease);
      if (status.ok()) {
        server_seen_ = Clock::now();
        if (!lease.lease_id().empty()) compute(lease);
      } else if (status.error_code() == grpc::StatusCode::FAILED_PRECONDITION) {
        logging::info("not wanted", {{"why", status.error_message()}});
        return;
      } else if (away_for_too_long()) {
        logging::warning("the server is away for too long", {{"error", status.error_message()}});
        return;
      } else {
        pause();
      }
    }
  }

 private:
  static std::string own_id() {
    std::random_device random;
    std::ostringstream id;
    id << "worker-" << std::hex << random() << random();
    return id.str();
  }

  /// A channel makes progress with its connection only while somebody waits for it.
  void pause() {
    channel_->WaitForConnected(std::chrono::system_clock::now() + std::chrono::milliseconds(200));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }

  bool away_for_too_long() const {
    return Clock::now() - server_seen_ > std::chrono::duration<double>(options_.grace_seconds);
  }

  grpc::Status ask(v1::LeaseResponse& lease) {
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(30));
    return server_->Lease(&context, request_, &lease);
  }

  void compute(const v1::LeaseResponse& lease) {
    logging::info("job begun", {{"job", lease.job_id()}, {"attempt", std::to_string(lease.attempt())}});
    std::optional<v1::CompleteRequest> outcome;
    {
      LeaseKeeper keeper(*server_, lease, options_.grace_seconds, leaving);
      outcome = run_job(lease, options_.threads, keeper);
    }
    if (outcome) complete(*outcome);
    logging::info("job left", {{"job", lease.job_id()}, {"lost", outcome ? "no" : "yes"}});
  }

  /// Until the server has heard it, or does not want to.
  void complete(const v1::CompleteRequest& outcome) {
    server_seen_ = Clock::now();
    while (true) {
      grpc::ClientContext context;
      context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(30));
      v1::CompleteResponse response;
      const grpc::Status status = server_->Complete(&context, outcome, &response);
      const bool heard = status.ok() || status.error_code() == grpc::StatusCode::NOT_FOUND;
      if (heard || leaving || away_for_too_long()) return;
      pause();
    }
  }

  const WorkOptions options_;
  const std::shared_ptr<grpc::Channel> channel_;
  const std::unique_ptr<v1::Workers::Stub> server_;
  v1::LeaseRequest request_;
  Clock::time_point server_seen_ = Clock::now();
};

/// If memory runs out, a worker costs one attempt; the server would cost everybody's connection.
void prefer_to_be_killed() { std::ofstream("/proc/self/oom_score_adj") << 800; }

}  // namespace

int work(const WorkOptions& options) {
  logging::start(options.log_level, "work");
  prefer_to_be_killed();
  const StopSignals signals;
  Worker(options).work_until_told();
  return 0;
}

}  // namespace trajan
