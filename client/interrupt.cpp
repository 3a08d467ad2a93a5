#include "client/interrupt.h"

#include <poll.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cstdint>

#include "client/exit_code.h"

namespace trajan::client {

InterruptWatch::InterruptWatch() {
  sigset_t watched;
  sigemptyset(&watched);
  sigaddset(&watched, SIGINT);
  sigaddset(&watched, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &watched, nullptr);
  signals_ = signalfd(-1, &watched, SFD_CLOEXEC);
  stop_ = eventfd(0, EFD_CLOEXEC);
  thread_ = std::thread([this] { listen(); });
}

InterruptWatch::~InterruptWatch() {
  const std::uint64_t one = 1;
  if (write(stop_, &one, sizeof one) == sizeof one) thread_.join();
  close(signals_);
  close(stop_);
}

void InterruptWatch::listen() {
  while (true) {
    pollfd files[] = {{signals_, POLLIN, 0}, {stop_, POLLIN, 0}};
    if (poll(files, 2, -1) < 0) continue;
    if (files[1].revents != 0) return;
    signalfd_siginfo signal;
    if (read(signals_, &signal, sizeof signal) != sizeof signal) continue;
    const std::lock_guard lock(mutex_);
    if (signalled_) _exit(static_cast<int>(ExitCode::detached));
    signalled_ = true;
    interrupted_ = true;
    if (reaction_) reaction_();
  }
}

void InterruptWatch::on_interrupt(std::function<void()> reaction) {
  const std::lock_guard lock(mutex_);
  reaction_ = std::move(reaction);
  if (interrupted_ && reaction_) reaction_();
}

}  // namespace trajan::client
