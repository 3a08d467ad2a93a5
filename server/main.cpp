#include <CLI/CLI.hpp>
#include <iostream>
#include <thread>

#include "proto/default_paths.h"
#include "server/address.h"
#include "server/measure.h"
#include "server/run_cost.h"
#include "server/server.h"
#include "server/worker.h"

namespace {

struct MeasuringOptions {
  std::string directory;
  double seconds = 1;
  int threads = 1;
};

void add_log_level(CLI::App& command, std::string& level) {
  command.add_option("--log-level", level, "Least level of messages on stderr")
      ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error", "critical", "off"}))
      ->capture_default_str();
}

void add_serve_options(CLI::App& command, trajan::ServeOptions& options) {
  command.add_option("--state", options.state, "Directory of the queue and the results")
      ->default_str("$XDG_STATE_HOME/trajan");
  command.add_option("--listen", options.listen,
                     "Address: unix:PATH, 127.0.0.1:PORT or [::1]:PORT; may be given several times");
  command.add_option("--workers", options.workers, "Worker processes on this machine")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  command.add_option("--threads-per-worker", options.threads_per_worker, "Threads of each worker's solver")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  const CLI::Range seconds(0.0, 86400.0, "seconds");
  command.add_option("--checkpoint-interval", options.schedule.checkpoint_seconds, "Seconds between checkpoints")
      ->check(seconds)
      ->capture_default_str();
  command
      .add_option("--lease", options.schedule.lease_seconds, "Seconds without a word after which a worker is lost")
      ->check(CLI::Range(1.0, 86400.0, "seconds"))
      ->capture_default_str();
  command
      .add_option("--cancel-grace", options.schedule.cancel_grace_seconds,
                  "Seconds after which a cancelled job's worker is ended by force")
      ->check(seconds)
      ->capture_default_str();
  command.add_option("--attempts", options.schedule.most_losses, "Workers that a job may lose before it fails")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      .add_option("--drain", options.drain_seconds, "Seconds that workers have to give their jobs back at the end")
      ->check(seconds)
      ->capture_default_str();
  command.add_flag(
      "--calibrate,!--no-calibrate", options.calibrate,
      "Measure what work takes on this machine for estimates, once, while there are no jobs (default: yes)");
  add_log_level(command, options.log_level);
}

void add_work_options(CLI::App& command, trajan::WorkOptions& options) {
  command.add_option("--server", options.server, "The server's address")->required();
  command.add_option("--threads", options.threads, "Threads of the solver")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command.add_option("--grace", options.grace_seconds, "Seconds to go on without a server")
      ->check(CLI::Range(0.0, 86400.0, "seconds"))
      ->capture_default_str();
  command.add_option("--worker-id", options.worker_id, "Set by the server for its own workers")->group("");
  add_log_level(command, options.log_level);
}

/// What the server has done beside it; of no use to people.
void add_measuring_options(CLI::App& calibrate, CLI::App& attempt, MeasuringOptions& options) {
  for (CLI::App* command : {&calibrate, &attempt})
    command->group("")->add_option("directory", options.directory, "Where question and answer are")->required();
  attempt.add_option("--seconds", options.seconds, "At most")->required();
  attempt.add_option("--threads", options.threads, "Threads of the solver");
}

}  // namespace

int main(int argument_count, char** arguments) {
  constexpr int exit_failure = 1;
  constexpr int exit_usage = 2;
  CLI::App program("Trajan's server and its workers", "trajand");
  program.set_version_flag("--version", TRAJAN_VERSION);
  program.require_subcommand(1);
  trajan::ServeOptions serve_options;
  serve_options.workers = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  trajan::WorkOptions work_options;
  CLI::App& serve = *program.add_subcommand("serve", "Take jobs and have workers compute them");
  CLI::App& work = *program.add_subcommand("work", "Compute jobs for a server");
  CLI::App& calibrate = *program.add_subcommand("calibrate", "Measure this machine");
  CLI::App& attempt = *program.add_subcommand("try", "Run a scene for a while");
  MeasuringOptions measuring;
  add_measuring_options(calibrate, attempt, measuring);
  add_serve_options(serve, serve_options);
  add_work_options(work, work_options);
  try {
    program.parse(argument_count, arguments);
    if (!serve.parsed()) trajan::give_back_freed_memory();
    if (work.parsed()) return trajan::work(work_options);
    if (calibrate.parsed()) return trajan::measuring::calibrate(measuring.directory);
    if (attempt.parsed())
      return trajan::measuring::try_scene(measuring.directory, measuring.seconds, measuring.threads);
    if (serve_options.state.empty()) serve_options.state = trajan::default_state_directory();
    return trajan::serve(serve_options);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : exit_usage;
  } catch (const trajan::UsageError& error) {
    std::cerr << "trajand: error: " << error.what() << '\n';
    return exit_usage;
  } catch (const std::exception& error) {
    std::cerr << "trajand: error: " << error.what() << '\n';
    return exit_failure;
  }
}
