#include "server/log.h"

#include <grpc/support/log.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <iomanip>
#include <sstream>

namespace trajan::logging {

namespace {

void write(spdlog::level::level_enum level, std::string_view event, Fields fields) {
  if (!spdlog::should_log(level)) return;
  std::ostringstream line;
  line << "event=" << std::quoted(event);
  for (const auto& [key, value] : fields) {
    line << ' ' << key << '=';
    if (value.empty() || value.find_first_of(" \"=\n") != std::string::npos) {
      line << std::quoted(value);
    } else {
      line << value;
    }
  }
  spdlog::log(level, line.str());
}

void write_grpc_message(gpr_log_func_args* message) {
  write(message->severity == GPR_LOG_SEVERITY_ERROR ? spdlog::level::warn : spdlog::level::debug,
        "message of gRPC", {{"text", message->message}});
}

}  // namespace

void start(const std::string& level, const std::string& role) {
  auto logger = std::make_shared<spdlog::logger>(role, std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_pattern("time=%Y-%m-%dT%H:%M:%S.%e%z level=%l role=%n pid=%P %v");
  logger->set_level(spdlog::level::from_str(level));
  spdlog::set_default_logger(std::move(logger));
  gpr_set_log_function(write_grpc_message);
}

void info(std::string_view event, Fields fields) { write(spdlog::level::info, event, fields); }
void warning(std::string_view event, Fields fields) { write(spdlog::level::warn, event, fields); }
void error(std::string_view event, Fields fields) { write(spdlog::level::err, event, fields); }

}  // namespace trajan::logging
