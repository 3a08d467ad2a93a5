#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "client/commands/command.h"
#include "client/terminal.h"
#include "proto/suggestion.h"

namespace {

using namespace trajan::client;

constexpr const char* notes =
    "Where the server is: --server, else $TRAJAN_SERVER, else `server = \"ADDRESS\"` in\n"
    "$XDG_CONFIG_HOME/trajan/config, else the socket of the default state directory.\n"
    "Data go to standard output, messages to standard error. $NO_COLOR is respected.\n"
    "\n"
    "Exit codes:\n"
    "  0    done\n"
    "  1    the job failed or was cancelled, or the server refused\n"
    "  2    wrong options, or a scene with mistakes\n"
    "  3    no server answers\n"
    "  4    no such job, file, column or scene\n"
    "  5    a file could not be written, or a program is missing\n"
    "  130  interrupted; the job goes on unless `trajan run` had a server of its own";

/// A word that is no command gets the nearest one as a hint.
ExitCode report_usage(const CLI::App& program, const CLI::ParseError& error, int count, char** words) {
  if (error.get_exit_code() == 0) {
    program.exit(error);
    return ExitCode::success;
  }
  std::vector<std::string> names;
  for (const Command& command : commands()) names.emplace_back(command.name);
  std::string hint = "`trajan --help` lists the commands";
  bool is_known = false;
  for (int i = 1; i < count && !is_known; ++i) {
    const std::string word = words[i];
    is_known = std::find(names.begin(), names.end(), word) != names.end();
    if (is_known) {
      hint = fmt::format("`trajan {} --help` says how it is used", word);
    } else if (!word.starts_with('-')) {
      say_error(fmt::format("there is no command \"{}\"", word), trajan::suggest(word, names, "the commands are"));
      return ExitCode::usage;
    }
  }
  say_error(error.what(), hint);
  return ExitCode::usage;
}

ExitCode perform(int count, char** words) {
  CLI::App program("Simulates solids with the material point method.", "trajan");
  GlobalOptions global;
  Action action;
  program.set_version_flag("--version", "trajan " TRAJAN_VERSION);
  program.add_option("--server", global.server, "Where the server is: unix:PATH or HOST:PORT")
      ->type_name("ADDRESS");
  program.require_subcommand(1);
  program.fallthrough();
  program.footer(notes);
  for (const Command& command : commands()) {
    command.declare(*program.add_subcommand(command.name, command.summary), global, action);
  }
  try {
    program.parse(count, words);
  } catch (const CLI::ParseError& error) {
    return report_usage(program, error, count, words);
  }
  if (!action) throw CommandError(ExitCode::usage, "serve and work come first on the command line");
  return action();
}

}  // namespace

int main(int count, char** words) {
  try {
    become_trajand(count, words);
    return static_cast<int>(perform(count, words));
  } catch (const CommandError& error) {
    std::cout.flush();
    say_error(error.what(), error.hint);
    return static_cast<int>(error.code);
  } catch (const std::exception& error) {
    say_error(fmt::format("a defect of trajan: {}", error.what()), {});
    return static_cast<int>(ExitCode::local_failure);
  }
}
