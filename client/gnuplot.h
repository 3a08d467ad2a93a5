#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace trajan::client {

/// A gnuplot string that means exactly `text`: nothing in it is a command, a format or a line break.
std::string gnuplot_text(std::string_view text);

/// The opening of a script: terminal by the suffix of `picture` (.png, .svg or .pdf), fonts, and the look of
/// axes and grid. Sizes in pixels. Throws CommandError (usage) for another suffix.
std::string gnuplot_opening(const std::filesystem::path& picture, int width, int height);

/// Colours that people with any kind of colour vision can tell apart (Okabe and Ito 2008), as "#rrggbb".
std::string_view line_colour(std::size_t number);

/// Runs gnuplot on a script in a process of its own, without a shell. Throws CommandError if gnuplot is
/// missing or refuses.
void run_gnuplot(const std::string& script, const std::filesystem::path& folder);

}  // namespace trajan::client
