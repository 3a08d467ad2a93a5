// The commands that need no server of their own: scenes, serve, work, completion.
#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <sstream>

#include "client/commands/all.h"
#include "client/gallery.h"
#include "client/scene_text.h"
#include "client/subprocess.h"
#include "proto/suggestion.h"

namespace trajan::client {
namespace {

struct Scenes {
  std::string name;
  OutputFormat output = OutputFormat::table;
};

/// Up to the end of its first sentence.
std::string first_sentence(const std::string& text) {
  const std::size_t end = text.find(". ");
  return end == std::string::npos ? text : text.substr(0, end + 1);
}

ExitCode scenes(const GlobalOptions&, const Scenes& asked) {
  Table table{{"scene", "description"}, {}};
  std::vector<std::string> names;
  for (const GalleryScene& scene : gallery()) {
    if (scene.name == asked.name) {
      std::cout << scene.text;
      return ExitCode::success;
    }
    names.emplace_back(scene.name);
    const SceneText text(std::string(scene.text), SceneFormat::text);
    table.rows.push_back({std::string(scene.name), first_sentence(text.scene().description())});
  }
  if (!asked.name.empty()) {
    throw CommandError(ExitCode::not_found, fmt::format("there is no gallery scene \"{}\"", asked.name),
                       suggest(asked.name, names, "the gallery has"));
  }
  print_table(std::cout, table, asked.output);
  return ExitCode::success;
}

struct Completion {
  std::string shell;
};

std::string joined_commands() {
  std::string words;
  for (const Command& command : commands()) words += fmt::format("{}{}", words.empty() ? "" : " ", command.name);
  return words;
}

/// The long options of a command, from the same declarations as its help.
std::string joined_options(const Command& command) {
  CLI::App app;
  GlobalOptions global;
  Action action;
  command.declare(app, global, action);
  std::string words;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames())
      words += fmt::format("{}--{}", words.empty() ? "" : " ", name);
  }
  return words;
}

std::string joined_scenes() {
  std::string words;
  for (const GalleryScene& scene : gallery()) words += fmt::format("{}{}", words.empty() ? "" : " ", scene.name);
  return words;
}

std::string bash_completion() {
  std::ostringstream script;
  script << "_trajan() {\n"
            "  local word=${COMP_WORDS[COMP_CWORD]} words=\n"
            "  if ((COMP_CWORD == 1)); then\n"
         << fmt::format("    words='{}'\n", joined_commands())
         << "  else\n"
            "    case ${COMP_WORDS[1]} in\n";
  for (const Command& command : commands()) {
    const std::string name = command.name;
    const bool takes_scene = name == "run" || name == "check" || name == "submit" || name == "scenes";
    const bool takes_job =
        std::string(" watch history fetch plot render show cancel rm ").find(' ' + name + ' ') !=
        std::string::npos;
    script << fmt::format("      {}) words='{}{}{}' ;;\n", name, joined_options(command),
                          takes_scene ? ' ' + joined_scenes() : "", takes_job ? " last" : "");
  }
  script << "    esac\n"
            "  fi\n"
            "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
            "}\n"
            "complete -o default -F _trajan trajan\n";
  return script.str();
}

ExitCode completion(const GlobalOptions&, const Completion& asked) {
  if (asked.shell == "zsh") std::cout << "autoload -U +X bashcompinit && bashcompinit\n";
  std::cout << bash_completion();
  return ExitCode::success;
}

}  // namespace

void declare_scenes(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<Scenes>();
  app.add_option("name", asked->name, "Print this scene instead of the list");
  add_output_option(app, asked->output, {"table", "json", "jsonl", "csv"});
  set_action(app, global, action, asked, scenes);
}

void become_trajand(int count, char** words) {
  const std::string command = count > 1 ? words[1] : "";
  if (command != "serve" && command != "work") return;
  const std::string program = find_trajand().string();
  execv(program.c_str(), words);
  throw CommandError(ExitCode::local_failure, "cannot start " + program);
}

void declare_delegated(CLI::App& app, const GlobalOptions&, Action&) {
  app.footer(fmt::format("Its options are those of `trajand {}`.", app.get_name()));
}

void declare_completion(CLI::App& app, const GlobalOptions& global, Action& action) {
  const auto asked = std::make_shared<Completion>();
  app.add_option("shell", asked->shell, "bash or zsh")->required()->check(CLI::IsMember({"bash", "zsh"}));
  app.footer("For bash: source <(trajan completion bash)");
  set_action(app, global, action, asked, completion);
}

}  // namespace trajan::client
