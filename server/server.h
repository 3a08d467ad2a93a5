#pragma once

#include <grpcpp/server.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "server/estimates_service.h"
#include "server/hub.h"
#include "server/jobs_service.h"
#include "server/pool.h"
#include "server/schedule.h"
#include "server/state_directory.h"
#include "server/store.h"
#include "server/studies_service.h"
#include "server/targets.h"
#include "server/workers_service.h"

namespace trajan {

struct ServeOptions {
  std::filesystem::path state;
  std::vector<std::string> listen;  ///< empty: a Unix socket in the state directory
  int workers = 1;
  int threads_per_worker = 1;
  ScheduleOptions schedule;  ///< jobs_directory follows from `state`
  double drain_seconds = 20;
  bool calibrate = true;  ///< measure this machine, if that is still to be done, while there are no jobs
  std::string log_level = "info";
};

/// A whole server: opens the state, listens, keeps the workers.
class Server {
 public:
  /// Throws UsageError for addresses that are not allowed, std::runtime_error if it cannot start.
  explicit Server(ServeOptions options);
  /// Ends at once, as far as `drain` did not; workers that compute live on.
  ~Server();

  /// Where it listens, in the order of the options.
  const std::vector<std::string>& addresses() const { return addresses_; }

  /// Takes no more jobs, lets workers give theirs back, ends all streams and stops listening.
  void drain();

 private:
  void listen();
  void start_workers();
  void remove_orphaned_directories();
  void keep_time(const std::stop_token& stop);
  /// Unless the store knows this machine already.
  void calibrate(const std::stop_token& stop);
  void stop_listening();

  ServeOptions options_;
  StateDirectory state_;
  store::Store store_;
  Hub hub_;
  WorkerPool pool_;
  Scheduler scheduler_;
  Targets targets_;
  Measurer measurer_;
  Estimator estimator_;
  JobsService jobs_;
  StudiesService studies_;
  EstimatesService estimates_;
  WorkersService workers_;
  std::vector<std::string> addresses_;
  std::unique_ptr<grpc::Server> server_;
  std::jthread clock_, calibration_;
};

/// Runs a server until SIGTERM or SIGINT, then drains; a second signal ends it at once. Prints
/// "listening on ADDRESS" for each address when it is ready. Returns the exit code.
int serve(const ServeOptions& options);

}  // namespace trajan
