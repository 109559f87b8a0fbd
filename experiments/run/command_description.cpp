// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/command_description.h"

#include <algorithm>
#include <string_view>

namespace touchstone::run {

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

}  // namespace touchstone::run
