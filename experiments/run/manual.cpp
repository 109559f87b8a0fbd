// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "experiments/run/help.h"

namespace touchstone::run {
namespace {

/// Returns a text in which nothing is a request or an escape of roff.
std::string roff(const std::string& text) {
  std::string escaped;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else
      escaped += c;
    begins_line = c == '\n';
  }
  return escaped;
}

std::string page_name(const CommandDescription& command) {
  std::string name = "touchstone";
  if (!command.name.empty()) name += "-" + command.name;
  std::ranges::replace(name, ' ', '-');
  return name;
}

std::string synopsis(const CommandDescription& command) {
  std::string text = ".B touchstone\n";
  for (const std::string& word : command.usage())
    text += word == command.name ? fmt::format(".B {}\n", roff(word)) : fmt::format("\\fI{}\\fR\n", roff(word));
  return text;
}

std::string option_text(const OptionDescription& option) {
  std::string text = fmt::format(".TP\n\\fB{}\\fR", roff(option.name));
  if (!option.value.empty() && !option.positional()) text += fmt::format(" \\fI{}\\fR", roff(option.value));
  return text + "\n" + roff(option.explanation()) + "\n";
}

/// Returns the paragraphs of a footer, in which lines that begin with a space are not filled.
std::string paragraphs(const std::string& footer) {
  std::string text;
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);)
    text +=
        (text.empty() ? "" : ".br\n") + (line.starts_with(" ") ? ".nf\n" + roff(line) + "\n.fi" : roff(line)) + "\n";
  return text;
}

std::string page(const CommandDescription& command, const std::string& version) {
  const std::string name = page_name(command);
  std::string text =
      fmt::format(".TH \"{}\" 1 \"\" \"{}\" \"Touchstone\"\n.ad l\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}", roff(name),
                  roff(version), roff(name), roff(command.about), synopsis(command));
  if (!command.footer.empty()) text += ".SH DESCRIPTION\n" + paragraphs(command.footer);
  if (!command.options.empty()) text += ".SH OPTIONS\n";
  for (const OptionDescription& option : command.options) text += option_text(option);
  if (!command.subcommands.empty()) text += ".SH COMMANDS\n";
  for (const std::string& heading : command.headings()) {
    if (!heading.empty()) text += ".SS " + roff(heading) + "\n";
    for (const CommandDescription& sub : command.subcommands)
      if (sub.heading == heading) text += fmt::format(".TP\n.BR {} (1)\n{}\n", roff(page_name(sub)), roff(sub.about));
  }
  if (!command.examples.empty()) {
    text += ".SH EXAMPLES\n.nf\n";
    for (const std::string& example : command.examples) text += roff("touchstone " + example) + "\n";
    text += ".fi\n";
  }
  text +=
      ".SH EXIT STATUS\n"
      ".TP\n"
      "0\n"
      "Done, and nothing was found wrong.\n"
      ".TP\n"
      "1\n"
      "Done, and something was found wrong, such as an expectation that is not met.\n"
      ".TP\n"
      "2\n"
      "Wrong input, a wrong command line, or output that cannot be written.\n"
      ".TP\n"
      "130\n"
      "Interrupted.\n";
  if (!command.name.empty()) text += ".SH SEE ALSO\n.BR touchstone (1)\n";
  return text;
}

void add_pages(const CommandDescription& command, const std::string& version,
               std::map<std::string, std::string>& pages) {
  pages[page_name(command) + ".1"] = page(command, version);
  for (const CommandDescription& sub : command.subcommands) add_pages(sub, version, pages);
}

}  // namespace

std::map<std::string, std::string> manual_pages(const CommandDescription& program, const std::string& version) {
  std::map<std::string, std::string> pages;
  add_pages(program, version, pages);
  return pages;
}

}  // namespace touchstone::run
