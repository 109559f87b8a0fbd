// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <vector>

#include "experiments/run/help.h"

namespace touchstone::run {
namespace {

/// Calls visit(command) for the program and all commands below.
template <class Visit>
void for_each_command(const CommandDescription& command, const Visit& visit) {
  visit(command);
  for (const CommandDescription& sub : command.subcommands) for_each_command(sub, visit);
}

/// Returns the subcommands of a command, and `help` for the program itself.
std::string subcommands_of(const CommandDescription& command) {
  std::string words;
  for (const CommandDescription& sub : command.subcommands) words += sub.word() + " ";
  return words + (command.name.empty() ? "help " : "");
}

std::string options_of(const CommandDescription& command) {
  std::string words;
  for (const OptionDescription& option : command.options)
    if (!option.positional()) words += option.name + " ";
  return words + "--help";
}

/// Returns the words that may follow the name of a command where none is begun: options only if no file may follow.
std::string words_after(const CommandDescription& command) {
  std::string words = subcommands_of(command);
  bool takes_files = false;
  for (const OptionDescription& option : command.options) {
    if (!option.positional()) continue;
    takes_files = takes_files || option.words.empty();
    for (const std::string& word : option.words) words += word + " ";
  }
  return takes_files ? words : words + options_of(command);
}

std::string joined_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : " ").append(word);
  return text;
}

/// Returns a meaning for a description of zsh's _arguments within single quotes.
std::string zsh_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\'') {
      escaped += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// Returns the name of the function that completes a command.
std::string zsh_function(const CommandDescription& command) {
  std::string name = "_touchstone";
  if (!command.name.empty()) name += "_" + command.name;
  for (char& c : name)
    if (c == ' ' || c == '-') c = '_';
  return name;
}

std::string zsh_group(const CommandDescription& command) {
  const bool is_program = command.name.empty();
  std::string text = fmt::format("{}() {{\n  local -a commands\n  commands=(\n", zsh_function(command));
  for (const CommandDescription& sub : command.subcommands)
    text += fmt::format("    '{}:{}'\n", sub.word(), zsh_text(sub.about));
  if (is_program) text += "    'help:Print the help of a command'\n";
  text += "  )\n  local curcontext=$curcontext state line\n  _arguments -C '--help[Print help]' ";
  for (const OptionDescription& option : command.options)
    text += fmt::format("'{}[{}]' ", option.name, zsh_text(option.about));
  text += "'1:command:->command' '*::argument:->argument'\n  case $state in\n";
  text += "    command) _describe command commands ;;\n    argument)\n      case $words[1] in\n";
  for (const CommandDescription& sub : command.subcommands)
    text += fmt::format("        {}) {} ;;\n", sub.word(), zsh_function(sub));
  if (is_program) text += "        help) _describe command commands ;;\n";
  return text + "      esac ;;\n  esac\n}\n\n";
}

std::string zsh_command(const CommandDescription& command) {
  std::string text = fmt::format("{}() {{\n  _arguments '--help[Print help]'", zsh_function(command));
  std::string positional = "_files";
  for (const OptionDescription& option : command.options) {
    if (option.positional()) {
      if (!option.words.empty()) positional = "(" + joined_words(option.words) + ")";
      continue;
    }
    text += fmt::format(" \\\n    '*{}[{}]", option.name, zsh_text(option.about));
    if (!option.value.empty())
      text += fmt::format(":{}:{}", zsh_text(option.value),
                          option.words.empty() ? "_files" : "(" + joined_words(option.words) + ")");
    text += "'";
  }
  return text + fmt::format(" \\\n    '*:argument:{}'\n}}\n\n", positional);
}

}  // namespace

std::string bash_completion(const CommandDescription& program) {
  std::string words, options, values, groups;
  for_each_command(program, [&](const CommandDescription& command) {
    words += fmt::format("    '{}') words='{}' ;;\n", command.name, words_after(command));
    options += fmt::format("    '{}') words='{}' ;;\n", command.name, options_of(command));
    for (const OptionDescription& option : command.options)
      if (!option.positional() && !option.value.empty())
        values += fmt::format("    '{} {}') words='{}' ;;\n", command.name, option.name, joined_words(option.words));
  });
  for (const CommandDescription& command : program.subcommands)
    if (!command.subcommands.empty()) groups.append(groups.empty() ? "" : "|").append(command.name);
  return fmt::format(R"(# Completion of touchstone for bash, written by `touchstone completion bash`.
_touchstone_values() {{
  case $1 in
{}    *) return 1 ;;
  esac
}}
_touchstone_options() {{
  case $1 in
{}  esac
}}
_touchstone_words() {{
  case $1 in
{}  esac
}}
# What these functions put into words is offered; where nothing is, bash offers files.
_touchstone() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command= words= first=1
  if [ "${{COMP_WORDS[1]}}" = help ] && [ "$COMP_CWORD" -gt 1 ]; then first=2; fi
  if [ "$COMP_CWORD" -gt "$first" ]; then command=${{COMP_WORDS[first]}}; fi
  case $command in
    {}) if [ "$COMP_CWORD" -gt $((first + 1)) ]; then command="$command ${{COMP_WORDS[first+1]}}"; fi ;;
  esac
  if ! _touchstone_values "$command $before"; then
    case $current in
      -*) _touchstone_options "$command" ;;
      *) _touchstone_words "$command" ;;
    esac
  fi
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o default -F _touchstone touchstone
)",
                     values, options, words, groups);
}

std::string zsh_completion(const CommandDescription& program) {
  std::string text =
      "#compdef touchstone\n# Completion of touchstone for zsh, written by `touchstone completion zsh`.\n\n";
  for_each_command(program, [&](const CommandDescription& command) {
    text += command.subcommands.empty() ? zsh_command(command) : zsh_group(command);
  });
  return text + "_touchstone \"$@\"\n";
}

}  // namespace touchstone::run
