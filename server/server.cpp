#include "server/server.h"

#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/security/server_credentials.h>
#include <grpcpp/server_builder.h>

#include <csignal>

#include "proto/default_paths.h"
#include "server/address.h"
#include "server/log.h"
#include "server/run_cost.h"
#include "server/store_estimates.h"
#include "server/store_jobs.h"

namespace trajan {

namespace {

using Clock = std::chrono::steady_clock;

ScheduleOptions with_jobs_directory(ScheduleOptions schedule, const StateDirectory& state) {
  schedule.jobs_directory = std::filesystem::absolute(state.jobs());
  return schedule;
}

ServeOptions with_local_addresses(ServeOptions options) {
  if (options.listen.empty()) {
    options.listen = {"unix:" + std::filesystem::absolute(socket_path(options.state)).string()};
  }
  for (const std::string& address : options.listen) require_local(address);
  return options;
}

void configure(grpc::ServerBuilder& builder) {
  constexpr int largest_request = 16 << 20;
  builder.SetMaxReceiveMessageSize(largest_request);
  builder.AddChannelArgument(GRPC_ARG_MAX_CONCURRENT_STREAMS, 1000);
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, 30'000);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 10'000);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MAX_PINGS_WITHOUT_DATA, 0);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 10'000);
}

}  // namespace

Server::Server(ServeOptions options)
    : options_(with_local_addresses(std::move(options))),
      state_(options_.state),
      store_(state_.database()),
      pool_(options_.workers,
            [this](const std::string& worker, const std::string& how) { scheduler_.worker_lost(worker, how); }),
      scheduler_(with_jobs_directory(options_.schedule, state_), store_, hub_, pool_,
                 [this](std::int64_t study) { targets_.look_at(study); }),
      targets_(store_, hub_, [this] { scheduler_.assign(); }),
      measurer_(std::filesystem::absolute(state_.measuring())),
      estimator_(store_, measurer_, options_.workers, options_.threads_per_worker),
      jobs_(store_, hub_, scheduler_, targets_, estimator_, std::filesystem::absolute(state_.jobs())),
      studies_(store_, scheduler_, estimator_),
      estimates_(store_, estimator_),
      workers_(scheduler_) {
  remove_orphaned_directories();
  scheduler_.recover();
  targets_.recover();
  listen();
  start_workers();
  clock_ = std::jthread([this](const std::stop_token& stop) { keep_time(stop); });
  if (options_.calibrate) calibration_ = std::jthread([this](const std::stop_token& stop) { calibrate(stop); });
}

/// Directories whose job was deleted just before a crash.
void Server::remove_orphaned_directories() {
  for (const auto& entry : std::filesystem::directory_iterator(state_.jobs())) {
    const std::string name = entry.path().filename().string();
    const bool known =
        store_.read([&](store::Database& database) { return store::exists(database, store::job_number(name)); });
    if (!known) std::filesystem::remove_all(entry.path());
  }
}

void Server::listen() {
  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  grpc::ServerBuilder builder;
  configure(builder);
  std::vector<int> ports(options_.listen.size());
  for (std::size_t i = 0; i < ports.size(); ++i) {
    builder.AddListeningPort(options_.listen[i], grpc::InsecureServerCredentials(), &ports[i]);
  }
  builder.RegisterService(&jobs_);
  builder.RegisterService(&studies_);
  builder.RegisterService(&estimates_);
  builder.RegisterService(&workers_);
  server_ = builder.BuildAndStart();
  for (std::size_t i = 0; i < ports.size(); ++i) {
    if (!server_ || ports[i] == 0) throw std::runtime_error("cannot listen on " + options_.listen[i]);
    addresses_.push_back(with_port(options_.listen[i], ports[i]));
  }
  for (const char* service :
       {v1::Jobs::service_full_name(), v1::Studies::service_full_name(), v1::Estimates::service_full_name()})
    server_->GetHealthCheckService()->SetServingStatus(service, true);
}

void Server::start_workers() {
  pool_.start({"/proc/self/exe", "work", "--server", addresses_[0], "--threads",
               std::to_string(options_.threads_per_worker), "--log-level", options_.log_level});
}

void Server::keep_time(const std::stop_token& stop) {
  constexpr auto tick = std::chrono::milliseconds(100);
  constexpr auto heartbeat = std::chrono::seconds(5);
  Clock::time_point next_heartbeat = Clock::now() + heartbeat;
  while (!stop.stop_requested()) {
    const auto now = Clock::now();
    pool_.tick(now);
    scheduler_.tick(now);
    if (now >= next_heartbeat) {
      hub_.wake_all();
      next_heartbeat = now + heartbeat;
    }
    std::this_thread::sleep_for(tick);
  }
}

void Server::calibrate(const std::stop_token& stop) {
  constexpr auto pause = std::chrono::milliseconds(100);
  constexpr int enough = 10;  // looks without a job: nobody is about to submit more
  const auto known = [](store::Database& database) { return store::find_calibration(database, machine_name()); };
  if (store_.read(known)) return;
  for (int idle = 0; idle < enough; idle = scheduler_.active() == 0 ? idle + 1 : 0) {
    if (stop.stop_requested()) return;
    std::this_thread::sleep_for(pause);
  }
  const auto calibration = measurer_.calibrate();
  if (!calibration) return;
  store_.commit([calibration](store::Database& database) { store::keep_calibration(database, *calibration); },
                [](std::exception_ptr) {});
  logging::info("machine measured", {{"rates", std::to_string(calibration->seconds().size())}});
}

void Server::drain() {
  logging::info("draining");
  calibration_.request_stop();
  measurer_.stop();
  server_->GetHealthCheckService()->SetServingStatus(false);
  jobs_.drain();
  studies_.drain();
  scheduler_.drain();
  pool_.stop(SIGTERM);
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(options_.drain_seconds));
  while ((scheduler_.active() > 0 || pool_.alive() > 0) && Clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  pool_.stop(SIGKILL);
  stop_listening();
}

void Server::stop_listening() {
  hub_.end_all();
  server_->Shutdown(std::chrono::system_clock::now() + std::chrono::seconds(1));
  server_->Wait();
}

Server::~Server() {
  measurer_.stop();
  calibration_ = {};
  clock_.request_stop();
  if (clock_.joinable()) clock_.join();
  if (server_) stop_listening();
  store_.close();
}

}  // namespace trajan
