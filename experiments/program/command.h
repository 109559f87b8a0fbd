// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/program/help.h"
#include "experiments/program/options.h"
#include "experiments/program/table.h"

namespace touchstone::program {

/// What the help says of a command besides its options.
struct CommandHelp {
  std::string heading;  ///< under which the help of the program lists it
  /// Printed after the options: each line a paragraph, which help wraps unless it begins with a space.
  std::string footer;
  /// Command lines without `touchstone`, which can be run as they are from the folder of the sources.
  std::vector<std::string> examples;
};

/// How a command is called.
struct Call {
  /// The command line that repeats the run: every option but --force that was given, or has a default and is not excluded.
  std::string line;
  /// Returns the options that change results, by their names without dashes, with their values.
  std::function<std::vector<std::pair<std::string, std::string>>()> result_options;
  std::vector<std::filesystem::path> parts;  ///< the folders of all parts in their order, if the run adds them up
};

/// A subcommand of the program: its options, and the function that it runs.
class Command : public OptionList {
 public:
  Command(const std::string& name, const std::string& about);
  /// A command that only groups subcommands, one of which must be given.
  Command(const std::string& name, const std::string& about, const std::vector<Command>& subcommands);

  CommandHelp& help();
  /// Adds tables to the description of what the command writes.
  void writes(const std::vector<TableDescription>& tables);
  /// Declares that the command is a study that can run by parts; it must keep its call.
  void take_parts();
  /// Sets a variable that receives, before the command runs, how it is called.
  void keep_call(Call& call);
  /// Sets the function that the command runs; `run` returns the exit status.
  void runs(std::function<int()> run);

  [[nodiscard]] std::string name() const;
  /// Returns whether the command is a study that can run by parts.
  [[nodiscard]] bool has_parts() const;
  /// Returns the tables of the command, or of its subcommand.
  [[nodiscard]] const std::vector<TableDescription>& tables() const;
  [[nodiscard]] const std::vector<Command>& subcommands() const;
  /// Returns what the help says.
  [[nodiscard]] CommandDescription description() const;

  /// Parses the arguments after the name of the command and runs it. Returns the exit status. Throws UsageError, and
  /// the exceptions of the run.
  int operator()(std::vector<std::string> arguments) const;
  /// Parses the arguments as above, and adds the parts in these folders up. Requires has_parts().
  int merge(const std::vector<std::filesystem::path>& folders, const std::vector<std::string>& arguments) const;
};

/// The texts of the program itself.
struct ProgramText {
  std::string about;
  std::string version;  ///< what --version prints
};

/// Returns the description of the program with these commands.
[[nodiscard]] CommandDescription description_of(const std::string& about, const std::vector<Command>& commands);

/// Parses the command line of the program and runs the command that it names. `help COMMAND` is `COMMAND --help`.
/// Prints help and the version; without a command, prints the help to stderr. Returns the exit status. Throws
/// UsageError, which names an unknown command, option or choice, with the most similar known one, and the exceptions of
/// the run.
int run_program(const ProgramText& text, const std::vector<Command>& commands, int argc, char** argv);

}  // namespace touchstone::program
