#include <grpc/grpc.h>

#include <csignal>
#include <cstdio>
#include <ctime>
#include <iostream>

#include "server/log.h"
#include "server/server.h"

namespace trajan {

namespace {

sigset_t stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  return signals;
}

/// Ends the process if a second signal comes, or `limit` seconds pass, before it has ended by itself.
void force_later(const sigset_t& signals, double limit) {
  std::thread([signals, limit] {
    const timespec timeout{static_cast<std::time_t>(limit), 0};
    const int signal = sigtimedwait(&signals, nullptr, &timeout);
    logging::warning("ended by force", {{"why", signal < 0 ? "draining took too long" : "second signal"}});
    std::_Exit(1);
  }).detach();
}

}  // namespace

int serve(const ServeOptions& options) {
  logging::start(options.log_level, "serve");
  const sigset_t signals = stop_signals();
  // Blocked in every thread; this one waits for them.
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  // Never given back: when the last user of gRPC leaves, it may wait ten seconds for connections that are just
  // closing, and the process ends here anyway.
  grpc_init();
  Server server(options);
  for (const std::string& address : server.addresses()) std::cout << "listening on " << address << std::endl;
  int signal = 0;
  sigwait(&signals, &signal);
  constexpr double slack_seconds = 10;
  force_later(signals, options.drain_seconds + slack_seconds);
  server.drain();
  return 0;
}

}  // namespace trajan
