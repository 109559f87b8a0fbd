// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace touchstone::program {

/// The description of an option in the help.
struct OptionDescription {
  std::string name;                 ///< `--name`, or the name of a positional argument
  std::string value;                ///< what its value is called, such as `N`; empty for a flag
  std::string about;                ///< its meaning
  std::string fallback;             ///< its default; empty if it has none
  std::vector<std::string> words;   ///< the only values that it takes, if they are listed
  std::vector<std::string> limits;  ///< sentences on which other options it needs or excludes
  bool required = false;
  bool repeats = false;  ///< takes all remaining arguments

  [[nodiscard]] bool positional() const { return !name.starts_with("--"); }
  /// Returns the meaning, the limits and the default, as sentences.
  [[nodiscard]] std::string explanation() const;
};

/// The description of a command in the help.
struct CommandDescription {
  std::string name;     ///< with the names of its groups, as in `corpus shrink`
  std::string heading;  ///< under which the help of the program lists it; empty for one list
  std::string about;
  std::string footer;  ///< each line a paragraph; one that begins with a space is printed as it is
  std::vector<OptionDescription> options;
  std::vector<std::string> examples;  ///< command lines without the name of the program
  std::vector<CommandDescription> subcommands;

  /// Returns the last word of the name.
  [[nodiscard]] std::string word() const { return name.substr(name.rfind(' ') + 1); }
  /// Returns the headings of the subcommands, in their order.
  [[nodiscard]] std::vector<std::string> headings() const;
  /// Returns the arguments, as the first line of the help has them: `judge [OPTIONS] [FILE...]`.
  [[nodiscard]] std::vector<std::string> usage() const;
};

/// Returns the help of a command, or of the program for an empty name.
///
/// No line is longer than `width`, except for a word that is itself longer; no word is cut. The second and later lines
/// of a meaning are indented as the first one. An example stays one command of a shell.
[[nodiscard]] std::string help_text(const CommandDescription& command, std::size_t width);

/// Returns the number of columns for help: the environment variable COLUMNS or, without it, the width of the terminal
/// to which standard output goes; otherwise 80.
[[nodiscard]] std::size_t help_width();

}  // namespace touchstone::program
