#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace trajan::logging {

using Fields = std::initializer_list<std::pair<std::string_view, std::string>>;

/// Logs to stderr, one line of key=value pairs for each event. `level`: trace, debug, info, warning,
/// error, critical or off. `role` says which process it is. gRPC's own messages come the same way.
void start(const std::string& level, const std::string& role);

void info(std::string_view event, Fields fields = {});
void warning(std::string_view event, Fields fields = {});
void error(std::string_view event, Fields fields = {});

}  // namespace trajan::logging
