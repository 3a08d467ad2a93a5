#pragma once

#include <string>
#include <string_view>

namespace trajan::client {

/// Whether standard error is a terminal, where a progress bar may redraw itself.
bool is_terminal();
/// Whether messages may have colours: a terminal, and NO_COLOR (no-color.org) unset or empty.
bool use_colours();
/// Columns of the terminal; 80 if they are not known.
int terminal_width();

/// A line for people, on standard error.
void say(std::string_view message);
/// `error: message`, and `hint: …` if there is one, on standard error.
void say_error(std::string_view message, std::string_view hint);

/// "850 B", "1.4 MiB"
std::string bytes_for_people(double bytes);
/// "0:07", "2:03:10"
std::string duration_for_people(double seconds);
/// "850", "1.4 M"
std::string count_for_people(double count);

}  // namespace trajan::client
