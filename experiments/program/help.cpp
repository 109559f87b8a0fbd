// SPDX-License-Identifier: GPL-3.0-or-later
// CLI11's own help does not wrap.
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "experiments/program/command.h"

namespace touchstone::program {

std::string OptionDescription::explanation() const {
  const auto with_stop = [](const std::string& text) {
    return text + (text.empty() || std::string_view(".?!").find(text.back()) != std::string_view::npos ? "" : ".");
  };
  std::string text = with_stop(about);
  if (required && !positional()) text += " Required.";
  for (const std::string& limit : limits) text += " " + with_stop(limit);
  for (const std::string& word : words) text.append(&word == &words.front() ? " One of: " : ", ").append(word);
  if (!words.empty()) text += ".";
  if (!fallback.empty()) text += " Default: " + fallback + ".";
  return text;
}

std::vector<std::string> CommandDescription::headings() const {
  std::vector<std::string> found;
  for (const CommandDescription& sub : subcommands)
    if (std::ranges::find(found, sub.heading) == found.end()) found.push_back(sub.heading);
  return found;
}

std::vector<std::string> CommandDescription::usage() const {
  std::vector<std::string> usage;
  if (!name.empty()) usage.push_back(name);
  if (!subcommands.empty()) usage.emplace_back("COMMAND");
  usage.emplace_back("[OPTIONS]");
  for (const OptionDescription& option : options) {
    if (!option.positional()) continue;
    const std::string word = option.name + (option.repeats ? "..." : "");
    usage.push_back(option.required ? word : "[" + word + "]");
  }
  return usage;
}

namespace {

using Words = std::vector<std::string>;

/// Returns the words between spaces. For a command of a shell, spaces within quotes do not count.
Words words_of(const std::string& text, bool is_command = false) {
  Words words;
  bool begins = true, quoted = false;
  for (const char c : text) {
    if (is_command && c == '\'') quoted = !quoted;
    if (c == ' ' && !quoted) {
      begins = true;
      continue;
    }
    if (begins) words.emplace_back();
    words.back() += c;
    begins = false;
  }
  return words;
}

/// Returns the words in lines of at most `width` columns. The first line begins at column `begin`; the others are
/// indented by `indent`, and `end` stands before each of them.
std::string wrapped(const Words& words, std::size_t begin, std::size_t indent, std::size_t width,
                    std::string_view end = "") {
  std::string text;
  std::size_t column = begin;
  for (const std::string& word : words) {
    if (&word != &words.front()) {
      const bool fits = column + 1 + word.size() + end.size() <= width;
      text += fits ? " " : std::string(end) + "\n" + std::string(indent, ' ');
      column = fits ? column + 1 : indent;
    }
    text += word;
    column += word.size();
  }
  return text;
}

struct Entry {
  std::string name, meaning;
};

std::string list(const std::string& title, const std::vector<Entry>& entries, std::size_t column, std::size_t width) {
  if (entries.empty()) return {};
  std::string text = "\n" + title + ":\n";
  for (const auto& [name, meaning] : entries) {
    std::string line = "  " + name;
    if (line.size() + 2 > column)
      line += "\n" + std::string(column, ' ');
    else
      line.resize(column, ' ');
    text += line + wrapped(words_of(meaning), column, column, width) + "\n";
  }
  return text;
}

/// Returns the column of the meanings: behind the longest name, unless that leaves too little room.
std::size_t column_of(const std::vector<std::vector<Entry>>& lists, std::size_t width) {
  std::size_t longest = 0;
  for (const auto& entries : lists)
    for (const Entry& entry : entries) longest = std::max(longest, entry.name.size());
  return std::min({longest + 4, std::size_t{30}, std::max(width / 3, std::size_t{4})});
}

std::string footer_text(const std::string& footer, std::size_t width) {
  std::string text = "\n";
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);)
    text += (line.starts_with(" ") ? line : wrapped(words_of(line), 0, 0, width)) + "\n";
  return text;
}

}  // namespace

std::string help_text(const CommandDescription& command, std::size_t width) {
  std::vector<Entry> arguments, options;
  for (const OptionDescription& option : command.options) {
    const std::string value = option.positional() || option.value.empty() ? "" : " " + option.value;
    (option.positional() ? arguments : options).push_back({option.name + value, option.explanation()});
  }
  options.push_back({"--help", "Print this help."});
  std::vector<std::vector<Entry>> groups;
  for (const std::string& heading : command.headings()) {
    groups.emplace_back();
    for (const CommandDescription& sub : command.subcommands)
      if (sub.heading == heading) groups.back().push_back({sub.word(), sub.about});
  }

  Words usage{"Usage:", "touchstone"};
  std::ranges::copy(command.usage(), std::back_inserter(usage));
  std::string text = wrapped(words_of(command.about), 0, 0, width) + "\n\n" + wrapped(usage, 0, 7, width) + "\n";
  const std::size_t commands = column_of(groups, width), column = column_of({arguments, options}, width);
  for (std::size_t i = 0; i < groups.size(); ++i)
    text += list(command.headings()[i].empty() ? "Commands" : command.headings()[i], groups[i], commands, width);
  text += list("Arguments", arguments, column, width) + list("Options", options, column, width);
  if (!command.footer.empty()) text += footer_text(command.footer, width);
  if (!command.examples.empty()) text += command.examples.size() == 1 ? "\nExample:\n" : "\nExamples:\n";
  for (const std::string& example : command.examples)
    text += "  " + wrapped(words_of("touchstone " + example, true), 2, 4, width, " \\") + "\n";
  return text;
}

std::size_t help_width() {
  const char* variable = std::getenv("COLUMNS");
  const std::string_view columns = variable == nullptr ? "" : variable;
  std::size_t width = 0;
  const auto [end, error] = std::from_chars(columns.data(), columns.data() + columns.size(), width);
  if (error == std::errc() && end == columns.data() + columns.size() && width > 0) return width;
  winsize terminal{};
  const bool is_terminal = ioctl(STDOUT_FILENO, TIOCGWINSZ, &terminal) == 0;
  constexpr std::size_t kUsual = 80;
  return is_terminal && terminal.ws_col > 0 ? terminal.ws_col : kUsual;
}

}  // namespace touchstone::program
