#include "client/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>

#include "client/utf8.h"

namespace trajan::client {
namespace {

/// As many columns as the text takes on a terminal: bytes that continue a UTF-8 character take none.
std::string padding(std::string_view text) {
  std::string spaces;
  for (const char byte : text) {
    if ((static_cast<unsigned char>(byte) & 0xC0) == 0x80) continue;
    spaces += byte == '\t' ? '\t' : ' ';
  }
  return spaces;
}

/// Control characters could move the cursor or change colours: scenes may come from strangers. What is not
/// UTF-8 would print as anything. The text keeps its length.
std::string printable(std::string_view text) {
  std::string result(text);
  std::replace_if(
      result.begin(), result.end(),
      [](char letter) { return (static_cast<unsigned char>(letter) < ' ' && letter != '\t') || letter == '\x7f'; },
      '?');
  const auto next_invalid = [&result](std::size_t from) {
    const std::size_t found = first_invalid_utf8(std::string_view(result).substr(from));
    return found == std::string_view::npos ? result.size() : from + found;
  };
  for (std::size_t at = next_invalid(0); at < result.size(); at = next_invalid(at)) result[at] = '?';
  return result;
}

}  // namespace

std::string format_diagnostic(const Diagnostic& diagnostic, const SceneText& scene, std::string_view file,
                              bool colours) {
  const char* bold = colours ? "\033[1m" : "";
  const char* red = colours ? "\033[1;31m" : "";
  const char* green = colours ? "\033[32m" : "";
  const char* plain = colours ? "\033[0m" : "";
  const Position at = diagnostic.position;
  const std::string place = at.line == 0 ? std::string(file) : fmt::format("{}:{}:{}", file, at.line, at.column);
  std::string text =
      fmt::format("{}{}:{} {}error:{} {}\n", bold, place, plain, red, plain, printable(diagnostic.message));
  const std::string line = printable(scene.line(at.line));
  constexpr std::size_t longest_line = 200;
  const std::size_t column = static_cast<std::size_t>(std::max(at.column - 1, 0));
  if (at.line > 0 && line.size() <= longest_line && column <= line.size()) {
    const std::size_t room = std::max<std::size_t>(line.size() - column, 1);
    const std::size_t length = std::clamp<std::size_t>(static_cast<std::size_t>(diagnostic.length), 1, room);
    const std::string tail(
        padding(std::string_view(line).substr(column, length)).size() - (column < line.size() ? 1 : 0), '~');
    text += fmt::format("{:5} | {}\n      | {}{}^{}{}\n", at.line, line,
                        padding(std::string_view(line).substr(0, column)), green, tail, plain);
  }
  if (!diagnostic.hint.empty()) text += fmt::format("      = hint: {}\n", printable(diagnostic.hint));
  return text;
}

}  // namespace trajan::client
