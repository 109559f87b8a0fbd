// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "experiments/program/command_parts.h"
#include "experiments/program/printing.h"
#include "experiments/program/words.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::program {
namespace {

/// Returns a word of a shell command, quoted only if needed.
std::string quoted_where_needed(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789,.:/_=+-";
  const bool is_plain = !word.empty() && word.find_first_not_of(kPlain) == std::string::npos;
  return is_plain ? word : shell_quoted(word);
}

/// Returns the name of a command with those of its groups; empty for the program.
std::string name_of(const CLI::App* app) {
  if (app->get_name() == kProgram) return {};
  const std::string group = app->get_parent() == nullptr ? "" : name_of(app->get_parent());
  return group + (group.empty() ? "" : " ") + app->get_name();
}

/// Returns whether an option was given that excludes this one.
bool is_excluded(const CLI::Option& option) {
  return std::ranges::any_of(option.get_excludes(), [](const CLI::Option* other) { return other->count() > 0; });
}

}  // namespace

std::string call_of(const std::string& name) { return kProgram + (name.empty() ? "" : " ") + name; }

UsageError fault_of(const CLI::App* app, const CLI::ParseError& error) {
  const auto unknown = app->remaining(true);
  while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
  const std::string name = name_of(app), see = "; see `" + call_of(name) + " --help`";
  if (unknown.empty()) {
    std::string said = error.what();
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ArgumentMismatch) && said.ends_with(" missing"))
      said = said.substr(0, said.find(':')) + ": its value is missing";
    return UsageError(io::all_legible(said) + (said.ends_with("?") ? "" : see));
  }
  std::vector<std::string> known;
  for (const CLI::Option* option : app->get_options()) known.push_back(option->get_name());
  const auto option = std::ranges::find_if(unknown, [](const std::string& word) { return word.starts_with("-"); });
  const std::string meant = option == unknown.end() ? "" : suggestion(*option, known);
  return UsageError((name.empty() ? "the program" : name) + " does not take: " +
                    io::all_legible(CLI::detail::join(unknown, " ")) + (meant.empty() ? see : meant));
}

void CommandParts::check_groups() const {
  for (const auto& group : groups) {
    const auto given = std::ranges::count_if(group, [&](const auto& name) { return app->count(name) > 0; });
    if (given != 1) throw CLI::RequiredError("exactly one of " + CLI::detail::join(group, ", "));
  }
}

void CommandParts::replace_defaults() const {
  for (const auto& [option, other] : replacing)
    if (option->count() > 0 && other->option->count() == 0) other->clear();
}

bool CommandParts::prints() const {
  const CLI::Option* quiet = app->get_option_no_throw("--quiet");
  return quiet == nullptr || quiet->count() == 0;
}

std::string CommandParts::line() const {
  std::string options_text, line = call_of(name_of(app.get()));
  for (const auto& declared : options) {
    const std::string& name = declared->name;
    const CLI::Option& option = *declared->option;
    if (name == "--force" || (option.count() == 0 && (!declared->has_default || is_excluded(option)))) continue;
    for (const std::string& word : declared->words()) {
      std::string& text = is_positional(name) ? line : options_text;
      if (!is_positional(name)) text += " " + name;
      if (!declared->value.empty()) text += " " + quoted_where_needed(word);
    }
  }
  return line + options_text;
}

std::vector<std::pair<std::string, std::string>> CommandParts::result_options() const {
  std::vector<std::pair<std::string, std::string>> values;
  for (const auto& declared : options)
    if (declared->changes_results)
      values.emplace_back(declared->name.substr(is_positional(declared->name) ? 0 : 2), declared->compared());
  return values;
}

Command::Command(const std::string& name, const std::string& about) : OptionList(std::make_shared<CommandParts>()) {
  parts().app = std::make_shared<CLI::App>(about, name);
  parts().app->formatter_fn([parts = &parts()](const CLI::App* app, const std::string&, CLI::AppFormatMode) {
    CommandDescription description = parts->description();
    description.name = name_of(app);
    return help_text(description, help_width());
  });
  // The application must not keep its own parts alive.
  parts().app->callback([parts = &parts()] {
    parts->check_groups();
    parts->replace_defaults();
    if (parts->call != nullptr) {
      parts->call->line = parts->line();
      parts->call->result_options = [parts] { return parts->result_options(); };
    }
    if (!parts->run) return;
    if (parts->prints()) require_standard_output();
    parts->status = parts->run();
  });
}

Command::Command(const std::string& name, const std::string& about, const std::vector<Command>& subcommands)
    : Command(name, about) {
  parts().subcommands = subcommands;
  parts().app->require_subcommand(1);
  for (const Command& command : subcommands) parts().app->add_subcommand(command.parts().app);
}

void Command::runs(std::function<int()> run) { parts().run = std::move(run); }

void Command::keep_call(Call& call) { parts().call = &call; }

CommandHelp& Command::help() { return parts().help; }

void Command::take_parts() { parts().takes_parts = true; }

void Command::writes(const std::vector<TableDescription>& tables) {
  parts().tables.insert(parts().tables.end(), tables.begin(), tables.end());
}

std::string Command::name() const { return app().get_name(); }

bool Command::has_parts() const { return parts().takes_parts; }

const std::vector<TableDescription>& Command::tables() const { return parts().tables; }

const std::vector<Command>& Command::subcommands() const { return parts().subcommands; }

CommandDescription CommandParts::description() const {
  CommandDescription description{.name = app->get_name(),
                                 .heading = help.heading,
                                 .about = app->get_description(),
                                 .footer = help.footer,
                                 .options = {},
                                 .examples = help.examples,
                                 .subcommands = {}};
  for (const auto& declared : options) {
    const CLI::Option& option = *declared->option;
    std::string fallback = option.get_default_str();
    // CLI11 puts lists into brackets.
    if (fallback.starts_with("[") && fallback.ends_with("]")) fallback = fallback.substr(1, fallback.size() - 2);
    description.options.push_back({.name = declared->name,
                                   .value = declared->value,
                                   .about = option.get_description(),
                                   .fallback = fallback,
                                   .words = declared->choices,
                                   .limits = declared->limits,
                                   .required = option.get_required(),
                                   .repeats = is_positional(declared->name) && option.get_expected_max() > 1});
  }
  for (const Command& command : subcommands) {
    description.subcommands.push_back(command.description());
    description.subcommands.back().name = app->get_name() + " " + command.name();
  }
  return description;
}

CommandDescription Command::description() const { return parts().description(); }

int Command::operator()(std::vector<std::string> arguments) const {
  std::ranges::reverse(arguments);
  try {
    app().parse(arguments);
  } catch (const CLI::ParseError& error) {
    throw fault_of(&app(), error);
  }
  for (const Command& command : parts().subcommands)
    if (command.parts().app->parsed()) return command.parts().status;
  return parts().status;
}

int Command::merge(const std::vector<std::filesystem::path>& folders, const std::vector<std::string>& arguments) const {
  parts().call->parts = folders;
  return (*this)(arguments);
}

}  // namespace touchstone::program
