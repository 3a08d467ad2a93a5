#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

namespace trajan::client {

enum class OutputFormat { table, json, jsonl, csv };

/// Nothing, text, a whole number or a number.
using Cell = std::variant<std::monostate, std::string, std::int64_t, double>;

/// Rows under named columns, for people or programs.
struct Table {
  std::vector<std::string> columns;  ///< keys in JSON; upper case in the table for people
  std::vector<std::vector<Cell>> rows;
};

/// The table for people rounds numbers to 6 digits; the other formats give the shortest text that reads
/// back to the same number. CSV follows RFC 4180 with "\n"; numbers that are not finite are `null` in JSON.
void print_table(std::ostream& out, const Table& table, OutputFormat format);

/// A JSON string with its quotes.
std::string json_string(std::string_view text);
/// The shortest JSON number that reads back to the same value, or null.
std::string json_number(double value);
/// A CSV cell, quoted if it must be.
std::string csv_text(std::string_view text);

}  // namespace trajan::client
