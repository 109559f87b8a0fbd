// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/harness/completion.h"

#include <fmt/core.h>

#include <vector>

namespace touchstone::harness {
namespace {

/// Calls visit(command) for the program and all commands below.
template <class Visit>
void for_each_command(const CommandDescription& command, const Visit& visit) {
  visit(command);
  for (const CommandDescription& sub : command.subcommands) for_each_command(sub, visit);
}

/// Returns the last word of the name of a command.
std::string last_word(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

/// Returns the words that may follow the name of a command: subcommands and options.
std::string words_after(const CommandDescription& command) {
  std::string words;
  for (const CommandDescription& sub : command.subcommands) words += last_word(sub.name) + " ";
  for (const OptionDescription& option : command.options)
    if (!option.positional()) words += option.name + " ";
  return words + "--help";
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
  std::string text = fmt::format("{}() {{\n  local -a commands\n  commands=(\n", zsh_function(command));
  for (const CommandDescription& sub : command.subcommands)
    text += fmt::format("    '{}:{}'\n", last_word(sub.name), zsh_text(sub.about));
  text += "  )\n  _arguments -C '--help[Print help]' ";
  if (command.name.empty()) text += "'--version[Print the version]' ";
  text += "'1:command:->command' '*::argument:->argument'\n  case $state in\n";
  text += "    command) _describe command commands ;;\n    argument)\n      case $words[1] in\n";
  for (const CommandDescription& sub : command.subcommands)
    text += fmt::format("        {}) {} ;;\n", last_word(sub.name), zsh_function(sub));
  return text + "      esac ;;\n  esac\n}\n\n";
}

std::string zsh_command(const CommandDescription& command) {
  std::string text = fmt::format("{}() {{\n  _arguments '--help[Print help]'", zsh_function(command));
  for (const OptionDescription& option : command.options) {
    if (option.positional()) continue;
    text += fmt::format(" \\\n    '*{}[{}]", option.name, zsh_text(option.about));
    if (!option.value.empty())
      text += fmt::format(":{}:{}", zsh_text(option.value),
                          option.words.empty() ? "_files" : "(" + joined_words(option.words) + ")");
    text += "'";
  }
  return text + " \\\n    '*:file:_files'\n}\n\n";
}

}  // namespace

std::string bash_completion(const CommandDescription& program) {
  std::string words, values;
  for_each_command(program, [&](const CommandDescription& command) {
    words += fmt::format("    '{}') words='{}' ;;\n", command.name, words_after(command));
    for (const OptionDescription& option : command.options)
      if (!option.words.empty())
        values += fmt::format("    '{} {}') words='{}' ;;\n", command.name, option.name, joined_words(option.words));
  });
  std::string groups;
  for (const CommandDescription& command : program.subcommands)
    if (!command.subcommands.empty()) groups.append(groups.empty() ? "" : "|").append(command.name);
  return fmt::format(R"(# Completion of touchstone for bash, written by `touchstone completion bash`.
_touchstone() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command= words=
  if [ "$COMP_CWORD" -gt 1 ]; then command=${{COMP_WORDS[1]}}; fi
  case $command in
    {}) if [ "$COMP_CWORD" -gt 2 ]; then command="$command ${{COMP_WORDS[2]}}"; fi ;;
  esac
  case "$command $before" in
{}    *)
      case $command in
{}      esac ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o default -F _touchstone touchstone
)",
                     groups, values, words);
}

std::string zsh_completion(const CommandDescription& program) {
  std::string text =
      "#compdef touchstone\n# Completion of touchstone for zsh, written by `touchstone completion zsh`.\n\n";
  for_each_command(program, [&](const CommandDescription& command) {
    text += command.subcommands.empty() ? zsh_command(command) : zsh_group(command);
  });
  return text + "_touchstone \"$@\"\n";
}

}  // namespace touchstone::harness
