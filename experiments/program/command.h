// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
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

#include "experiments/program/table.h"

namespace CLI {
class App;
}  // namespace CLI

namespace touchstone::program {

/// A faulty command line; the message names the option.
class UsageError : public std::runtime_error {
 public:
  UsageError(const std::string& option, const std::string& reason) : std::runtime_error(option + ": " + reason) {}
  explicit UsageError(const std::string& message) : std::runtime_error(message) {}
};

/// A check of the text of an option: returns the fault if it is empty, else nothing.
[[nodiscard]] inline std::string not_empty(const std::string& text) { return text.empty() ? "is empty" : ""; }
/// Returns a check that `read` reads the text: the fault is what it says by std::invalid_argument.
template <class Read>
[[nodiscard]] auto readable_by(const Read& read) {
  return [read](const std::string& text) -> std::string {
    try {
      (void)read(text);
      return {};
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
}

struct CommandParts;
struct Declared;

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

/// The options of a command, each declared once.
///
/// An option is bound to a variable, whose value at the declaration is the default. The variables must live as long as
/// the command, for example in a struct that the function given to `runs` shares. Names begin with `--`; other names
/// are positional arguments. The declarations yield the parser, its errors, the help, and the command line that repeats
/// a run.
class OptionList {
 public:
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

  [[nodiscard]] CommandParts& parts() const { return *parts_; }

 protected:
  explicit OptionList(std::shared_ptr<CommandParts> parts) : parts_(std::move(parts)) {}
  [[nodiscard]] CLI::App& app() const;

 private:
  Option whole_number_option(const std::string& name, const std::function<std::uint64_t()>& get,
                             const std::function<void(std::uint64_t)>& set, const std::string& about,
                             std::uint64_t lowest, std::uint64_t highest);

  Option word_option(const std::string& name, const std::function<std::string()>& get,
                     const std::function<void(std::size_t)>& set, const std::vector<std::string>& words,
                     const std::string& about);

  std::shared_ptr<CommandParts> parts_;
};

/// Declares a finite number above 0.
Option declare_positive(OptionList& options, const std::string& name, double& value, const std::string& about);
/// Requires exactly one of these options.
void require_one_of(OptionList& options, const std::vector<std::string>& names);

// Options that several commands share.
Option declare_seed(OptionList& options, std::uint64_t& value,
                    const std::string& about = "Seed; equal seeds give equal bytes");
Option declare_threads(OptionList& options, unsigned& value,
                       const std::string& about = "Number of threads; does not affect the results");
Option declare_methods(OptionList& options, std::vector<std::string>& values,
                       const std::string& about = "Methods, separated by commas: names, or all");
Option declare_families(OptionList& options, std::vector<std::string>& values);
Option declare_meshes(OptionList& options, std::vector<std::string>& files, const std::string& about = "Mesh files");
Option declare_folder(OptionList& options, std::string& folder, const std::string& about);
Option declare_no_pictures(OptionList& options, bool& value);
Option declare_force(OptionList& options, bool& value);
Option declare_json(OptionList& options, bool& value, const std::string& about);
Option declare_quiet(OptionList& options, bool& value, const std::string& about = "Print neither tables nor progress");

/// Joins words with commas, as the value of an option.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);
/// Returns the number of threads of this machine, the default of --threads.
[[nodiscard]] unsigned all_threads();

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

}  // namespace touchstone::program
