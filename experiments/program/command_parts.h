// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/program/command.h"

namespace touchstone::program {

/// An option, and the words of its value as the command line would hold them.
struct Declared {
  std::string name;
  CLI::Option* option;
  bool has_default;
  std::string value;  ///< what the help calls it; empty for a flag
  std::function<std::vector<std::string>()> words;
  std::vector<std::string> choices{};  ///< the only values, if they are listed
  std::function<void()> clear{};       ///< empties the value
  bool changes_results = false;
  std::function<std::string()> canonical{};
  std::vector<std::string> limits{};  ///< sentences for the help: other options that it needs or excludes

  /// Returns the value that is compared when parts are merged.
  [[nodiscard]] std::string compared() const {
    return canonical ? canonical() : value.empty() ? (words().empty() ? "no" : "yes") : joined(words());
  }
};

struct CommandParts {
  std::shared_ptr<CLI::App> app;
  std::vector<std::shared_ptr<Declared>> options;
  std::function<int()> run;
  Call* call = nullptr;
  bool takes_parts = false;
  std::vector<TableDescription> tables;
  std::vector<Command> subcommands;
  std::vector<std::vector<std::string>> groups;  ///< exactly one option of each is required
  /// Options, and those whose defaults they replace.
  std::vector<std::pair<const CLI::Option*, std::shared_ptr<Declared>>> replacing{};
  CommandHelp help{};
  int status = 0;

  Option declare(Declared declared) {
    options.push_back(std::make_shared<Declared>(std::move(declared)));
    return Option(*this, options.back());
  }
  void check_groups() const;
  void replace_defaults() const;
  /// Returns whether the command prints, for all it was told.
  [[nodiscard]] bool prints() const;
  [[nodiscard]] std::string line() const;
  [[nodiscard]] CommandDescription description() const;
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> result_options() const;
};

/// The name of the program.
inline const std::string kProgram = "touchstone";
/// Returns the words that call a command of this name.
[[nodiscard]] std::string call_of(const std::string& name);
/// Returns the fault of a command line, with the unknown words in their order.
[[nodiscard]] UsageError fault_of(const CLI::App* app, const CLI::ParseError& error);

[[nodiscard]] inline bool is_positional(const std::string& name) { return !name.starts_with("--"); }

}  // namespace touchstone::program
