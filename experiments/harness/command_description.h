// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace touchstone::harness {

/// The description of an option in the help.
struct OptionDescription {
  std::string name;                ///< `--name`, or the name of a positional argument
  std::string value;               ///< the kind of its value, such as `UINT`; empty for a flag
  std::string about;               ///< its meaning
  std::string fallback;            ///< its default; empty if it has none
  std::vector<std::string> words;  ///< the only values that it takes, if they are listed
  bool required = false;

  [[nodiscard]] bool positional() const { return !name.starts_with("--"); }
};

/// The description of a command in the help.
struct CommandDescription {
  std::string name;  ///< with the names of its groups, as in `corpus shrink`
  std::string about, footer;
  std::vector<OptionDescription> options;
  std::vector<std::string> examples;  ///< command lines without the name of the program
  std::vector<CommandDescription> subcommands;
};

}  // namespace touchstone::harness
