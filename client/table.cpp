#include "client/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace trajan::client {
namespace {

/// Columns that a text takes on a terminal, one per UTF-8 character.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

std::string for_people(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *whole);
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{:.6g}", *number);
  return "-";
}

std::string for_json(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return json_string(*text);
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *whole);
  if (const auto* number = std::get_if<double>(&cell)) return json_number(*number);
  return "null";
}

std::string for_csv(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return csv_text(*text);
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *whole);
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{}", *number);
  return {};
}

std::string json_object(const Table& table, const std::vector<Cell>& row) {
  std::string object = "{";
  for (std::size_t i = 0; i < row.size(); ++i) {
    object += fmt::format("{}{}: {}", i == 0 ? "" : ", ", json_string(table.columns[i]), for_json(row[i]));
  }
  return object + "}";
}

bool is_text(const Cell& cell) { return std::holds_alternative<std::string>(cell); }

void print_for_people(std::ostream& out, const Table& table) {
  std::vector<std::vector<std::string>> lines(1);
  for (const std::string& column : table.columns) {
    std::string heading = column;
    std::transform(heading.begin(), heading.end(), heading.begin(),
                   [](unsigned char c) { return std::toupper(c); });
    std::replace(heading.begin(), heading.end(), '_', ' ');
    lines[0].push_back(std::move(heading));
  }
  for (const std::vector<Cell>& row : table.rows) {
    std::vector<std::string>& line = lines.emplace_back();
    for (const Cell& cell : row) line.push_back(for_people(cell));
  }
  std::vector<std::size_t> widths(table.columns.size(), 0);
  std::vector<bool> left(table.columns.size(), false);
  for (std::size_t i = 0; i < widths.size(); ++i) {
    for (const auto& line : lines) widths[i] = std::max(widths[i], width_of(line[i]));
    left[i] = std::any_of(table.rows.begin(), table.rows.end(), [i](const auto& row) { return is_text(row[i]); });
  }
  for (const auto& line : lines) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string padding(widths[i] - width_of(line[i]), ' ');
      text += (i == 0 ? "" : "  ") + (left[i] ? line[i] + padding : padding + line[i]);
    }
    out << text.erase(text.find_last_not_of(' ') + 1) << '\n';
  }
}

}  // namespace

std::string json_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') {
      quoted += '\\';
      quoted += letter;
    } else if (static_cast<unsigned char>(letter) < ' ') {
      quoted += fmt::format("\\u{:04x}", static_cast<int>(letter));
    } else {
      quoted += letter;
    }
  }
  return quoted + '"';
}

std::string json_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

std::string csv_text(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"') quoted += '"';
    quoted += letter;
  }
  return quoted + '"';
}

void print_table(std::ostream& out, const Table& table, OutputFormat format) {
  if (format == OutputFormat::table) {
    print_for_people(out, table);
  } else if (format == OutputFormat::csv) {
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      out << (i == 0 ? "" : ",") << csv_text(table.columns[i]);
    out << '\n';
    for (const auto& row : table.rows) {
      for (std::size_t i = 0; i < row.size(); ++i) out << (i == 0 ? "" : ",") << for_csv(row[i]);
      out << '\n';
    }
  } else if (format == OutputFormat::jsonl) {
    for (const auto& row : table.rows) out << json_object(table, row) << '\n';
  } else {
    out << "[";
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      out << (i == 0 ? "\n  " : ",\n  ") << json_object(table, table.rows[i]);
    }
    out << (table.rows.empty() ? "]\n" : "\n]\n");
  }
}

}  // namespace trajan::client
