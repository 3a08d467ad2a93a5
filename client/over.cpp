#include "client/over.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <vector>

#include "client/exit_code.h"

namespace trajan::client {
namespace {

constexpr int most_values = 1000;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool quoted = false;
  for (const char letter : text) {
    if (letter == '"') quoted = !quoted;
    if (!quoted && (letter == '{' || letter == '[')) ++depth;
    if (!quoted && (letter == '}' || letter == ']')) --depth;
    if (letter == separator && depth == 0 && !quoted) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

template <typename Number>
std::optional<Number> parse(const std::string& text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Empty if the text is not FROM:TO:COUNT.
std::vector<std::string> parse_range(const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() != 3) return {};
  const auto from = parse<double>(parts[0]);
  const auto to = parse<double>(parts[1]);
  const auto count = parse<int>(parts[2]);
  if (!from || !to || !count || *count < 2 || *count > most_values) return {};
  std::vector<std::string> values;
  for (int i = 0; i < *count; ++i) {
    const double share = static_cast<double>(i) / (*count - 1);
    // 15 digits, so that 0.1 and 0.2 are not followed by 0.30000000000000004.
    values.push_back(fmt::format("{:.15g}", *from * (1 - share) + *to * share));
  }
  return values;
}

}  // namespace

v1::Dial parse_over(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos || equals + 1 == text.size()) {
    throw CommandError(ExitCode::usage, fmt::format("--over {}: it is not PATH=VALUES", text),
                       "as in domain.cell_size=0.1,0.2 or loads[end].time=1:3:5");
  }
  v1::Dial dial;
  dial.set_name(text.substr(0, equals));
  const std::string values = text.substr(equals + 1);
  std::vector<std::string> list = parse_range(values);
  if (list.empty()) list = split(values, ',');
  for (const std::string& value : list) {
    v1::Setting& setting = *dial.add_settings();
    setting.set_name(value);
    setting.add_changes(dial.name() + "=" + value);
  }
  return dial;
}

}  // namespace trajan::client
