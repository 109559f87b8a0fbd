// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "experiments/run/help.h"
#include "experiments/run/table.h"

namespace CLI {
class App;
}  // namespace CLI

namespace touchstone::run {

/// A faulty command line; the message names the option.
class UsageError : public std::runtime_error {
 public:
  UsageError(const std::string& option, const std::string& reason) : std::runtime_error(option + ": " + reason) {}
  explicit UsageError(const std::string& message) : std::runtime_error(message) {}
};

/// A check of the text of an option: returns the fault if it is empty, else nothing.
[[nodiscard]] inline std::string not_empty(const std::string& text) { return text.empty() ? "is empty" : ""; }

struct CommandParts;
struct Declared;

/// The texts of the program itself.
struct ProgramText {
  std::string about;
  std::string version;  ///< what --version prints
};

/// A declared option. Other options are named as on the command line and must be declared before.
class Option {
 public:
  Option& required();
  Option& needs(const std::string& other);
  Option& excludes(const std::string& other);
  /// Excludes every option that was declared before, except these.
  Option& excludes_all_but(const std::vector<std::string>& others);
  /// Declares that results depend on this option, so that parts with other values are not merged. `canonical` returns
  /// the value in its canonical form; without it, the value itself is compared, of a flag yes or no.
  Option& changes_results(std::function<std::string()> canonical = {});
  /// Sets what the help calls the value, such as `FILE`.
  Option& takes(const std::string& word);
  /// Given without the other option, empties the default of that one, which must be declared by `names`.
  Option& replaces_default_of(const std::string& other);

 private:
  friend struct CommandParts;
  Option(CommandParts& parts, std::shared_ptr<Declared> declared) : parts_(&parts), declared_(std::move(declared)) {}

  CommandParts* parts_;
  std::shared_ptr<Declared> declared_;
};

/// A subcommand of the program: its options, each declared once, and the function that it runs.
///
/// An option is bound to a variable, whose value at the declaration is the default. The variables must live as long as
/// the command, for example in a struct that the function given to `runs` shares. Names begin with `--`; other names
/// are positional arguments. The declarations yield the parser, its errors, the help, and the command line that repeats
/// a run.
class Command {
 public:
  Command(const std::string& name, const std::string& about);
  /// A command that only groups subcommands, one of which must be given.
  Command(const std::string& name, const std::string& about, const std::vector<Command>& subcommands);

  Option flag(const std::string& name, bool& value, const std::string& about);
  /// Returns the fault of a text, or an empty string.
  using Check = std::function<std::string(const std::string&)>;
  Option text(const std::string& name, std::string& value, const std::string& about, const Check& check = {});
  /// A choice of one of these words.
  Option choice(const std::string& name, std::string& value, const std::vector<std::string>& words,
                const std::string& about);
  /// A choice of one of these enumerators, by to_string(enumerator).
  template <class Enumerator>
  requires std::is_enum_v<Enumerator> Option choice(const std::string& name, Enumerator& value,
                                                    const std::vector<Enumerator>& all, const std::string& about) {
    std::vector<std::string> words;
    for (const Enumerator one : all) words.emplace_back(to_string(one));
    return word_option(
        name, [&value] { return std::string(to_string(value)); },
        [&value, all](std::size_t index) { value = all[index]; }, words, about);
  }
  /// Values separated by commas.
  Option names(const std::string& name, std::vector<std::string>& values, const std::string& about);
  /// For a positional name, takes all remaining arguments. With `--`, the option may be repeated, with one value each.
  Option texts(const std::string& name, std::vector<std::string>& values, const std::string& about,
               const Check& check = {});
  /// An integer from `lowest` to `highest`. A default outside this range means that the option has no default.
  template <std::unsigned_integral T>
  Option whole(const std::string& name, T& value, const std::string& about, std::uint64_t lowest = 0,
               std::uint64_t highest = std::numeric_limits<T>::max()) {
    return whole_number_option(
        name, [&value] { return std::uint64_t{value}; }, [&value](std::uint64_t n) { value = static_cast<T>(n); },
        about, lowest, highest);
  }
  Option integer(const std::string& name, int& value, const std::string& about);
  /// A decimal number whose nearest double is from `lowest` to `highest`. A default outside this range means that the
  /// option has no default.
  Option real(const std::string& name, double& value, const std::string& about,
              double lowest = std::numeric_limits<double>::lowest(),
              double highest = std::numeric_limits<double>::max());
  /// A finite number above 0.
  Option positive(const std::string& name, double& value, const std::string& about);
  /// Requires exactly one of these options, or allows at most one.
  void require_one_of(const std::vector<std::string>& names);
  void allow_one_of(const std::vector<std::string>& names);

  // Options that several commands share.
  Option seed(std::uint64_t& value, const std::string& about = "Seed; equal seeds give equal bytes");
  Option threads(unsigned& value, const std::string& about = "Number of threads; does not affect the results");
  Option methods(std::vector<std::string>& values,
                 const std::string& about = "Methods, separated by commas: names, or all");
  Option families(std::vector<std::string>& values);
  Option meshes(std::vector<std::string>& files, const std::string& about = "Mesh files");
  Option output(std::string& folder, const std::string& about);
  Option no_pictures(bool& value);
  Option force(bool& value);
  Option json(bool& value, const std::string& about);
  Option quiet(bool& value, const std::string& about = "Print neither tables nor progress");

  /// Sets the heading under which the help of the program lists the command.
  void heading(const std::string& heading);
  /// Sets a text that the help prints after the options: each line a paragraph, which help wraps unless it begins with
  /// a space.
  void footer(const std::string& text);
  /// Adds a command line, without `touchstone`, that the help prints at its end. It can be run as it is, from the
  /// folder of the sources.
  void example(const std::string& line);
  /// Sets the function that the command runs; `run` returns the exit status.
  void runs(std::function<int()> run);
  /// Sets a variable that receives, before the command runs, the command line that repeats the run: every option that
  /// has a default or was given, except --force.
  void keep_line(std::string& line);
  /// Sets a variable that receives, before the command runs, a function: it returns the options that change results by
  /// their names without dashes, with their values.
  void keep_result_options(std::function<std::vector<std::pair<std::string, std::string>>()>& options);
  /// Adds tables to the description of what the command writes.
  void writes(const std::vector<TableDescription>& tables);

  /// Declares that the command is a study that can run by parts, and sets the variable that tells it to add the parts
  /// in these folders up instead.
  void merges(std::vector<std::filesystem::path>& parts);

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
  int merge(const std::vector<std::filesystem::path>& parts, const std::vector<std::string>& arguments) const;

 private:
  friend int run_program(const ProgramText& text, const std::vector<Command>& commands, int argc, char** argv);
  [[nodiscard]] CLI::App& app() const;
  Option whole_number_option(const std::string& name, const std::function<std::uint64_t()>& get,
                             const std::function<void(std::uint64_t)>& set, const std::string& about,
                             std::uint64_t lowest, std::uint64_t highest);

  Option word_option(const std::string& name, const std::function<std::string()>& get,
                     const std::function<void(std::size_t)>& set, const std::vector<std::string>& words,
                     const std::string& about);

  std::shared_ptr<CommandParts> parts_;
};

/// Returns the number of threads of this machine, the default of --threads.
[[nodiscard]] unsigned all_threads();

/// Returns the description of the program with these commands.
[[nodiscard]] CommandDescription description_of(const std::string& about, const std::vector<Command>& commands);

/// Parses the command line of the program and runs the command that it names. `help COMMAND` is `COMMAND --help`.
/// Prints help and the version; without a command, prints the help to stderr. Returns the exit status. Throws
/// UsageError, which names an unknown command, option or choice, with the most similar known one, and the exceptions of
/// the run.
int run_program(const ProgramText& text, const std::vector<Command>& commands, int argc, char** argv);

}  // namespace touchstone::run
