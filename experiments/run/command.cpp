// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "experiments/run/help.h"
#include "experiments/run/numbers.h"
#include "experiments/run/printing.h"
#include "experiments/run/quoting.h"
#include "experiments/run/run_record.h"
#include "experiments/run/similar_words.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::run {
namespace {

const std::string kProgram = "touchstone";

bool is_positional(const std::string& name) { return !name.starts_with("--"); }

/// Returns a word of a shell command, quoted only if needed.
std::string quoted_where_needed(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789,.:/_=+-";
  const bool is_plain = !word.empty() && word.find_first_not_of(kPlain) == std::string::npos;
  return is_plain ? word : shell_quoted(word);
}

/// Returns the shortest text that reads back as the same number.
std::string shortest(double number) {
  std::array<char, 32> text;
  return {text.begin(), std::to_chars(text.begin(), text.end(), number).ptr};
}

/// Returns the name of a command with those of its groups; empty for the program.
std::string name_of(const CLI::App* app) {
  if (app->get_name() == kProgram) return {};
  const std::string group = app->get_parent() == nullptr ? "" : name_of(app->get_parent());
  return group + (group.empty() ? "" : " ") + app->get_name();
}

/// Returns the words that call a command of this name.
std::string call_of(const std::string& name) { return kProgram + (name.empty() ? "" : " ") + name; }

/// Returns the fault of a command line, with the unknown words in their order.
UsageError fault_of(const CLI::App* app, const CLI::ParseError& error) {
  const auto unknown = app->remaining(true);
  while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
  const std::string name = name_of(app), see = "; see `" + call_of(name) + " --help`";
  if (unknown.empty()) {
    std::string said = error.what();
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ArgumentMismatch) && said.ends_with(" missing"))
      said = said.substr(0, said.find(':')) + ": its value is missing";
    return UsageError(io::all_legible(said) + (said.ends_with("?") ? "" : see));
  }
  std::vector<std::string> known;
  for (const CLI::Option* option : app->get_options()) known.push_back(option->get_name());
  const auto option = std::ranges::find_if(unknown, [](const std::string& word) { return word.starts_with("-"); });
  const std::string meant = option == unknown.end() ? "" : suggestion(*option, known);
  return UsageError((name.empty() ? "the program" : name) + " does not take: " +
                    io::all_legible(CLI::detail::join(unknown, " ")) + (meant.empty() ? see : meant));
}

/// Returns a check that a text is one of the words.
CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto check = [words](const std::string& text) -> std::string {
    if (std::ranges::find(words, text) != words.end()) return {};
    return "\"" + text + "\" is not one of " + CLI::detail::join(words, ", ") + suggestion(text, words);
  };
  return {check, ""};
}

std::string check_utf8(const std::string& name) {
  try {
    (void)nlohmann::json(name).dump();
    return {};
  } catch (const nlohmann::json::exception&) {
    return "the name of a file is not UTF-8: " + io::legible(name);
  }
}

}  // namespace

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

  /// Returns the value that is compared when a run continues another one.
  [[nodiscard]] std::string compared() const { return canonical ? canonical() : joined(words()); }
};

struct CommandParts {
  std::shared_ptr<CLI::App> app;
  std::vector<std::shared_ptr<Declared>> options;
  std::function<int()> run;
  std::string* kept_line = nullptr;
  std::function<std::vector<std::pair<std::string, std::string>>()>* kept_result_options = nullptr;
  std::vector<std::filesystem::path>* merged_parts = nullptr;
  std::vector<TableDescription> tables;
  std::vector<Command> subcommands;
  std::vector<std::vector<std::string>> groups;  ///< exactly one option of each is required
  /// Options, and those whose defaults they replace.
  std::vector<std::pair<const CLI::Option*, std::shared_ptr<Declared>>> replacing{};
  std::string heading{}, footer{};
  std::vector<std::string> examples{};
  int status = 0;

  Option declare(Declared declared) {
    options.push_back(std::make_shared<Declared>(std::move(declared)));
    return Option(*this, options.back());
  }
  /// Notes in the help of each of these options how it excludes the others: `begin` --other, --other.
  void note_others(const std::vector<std::string>& names, const std::string& begin);
  void check_groups() const;
  void replace_defaults() const;
  /// Returns whether the command prints, for all it was told.
  [[nodiscard]] bool prints() const;
  [[nodiscard]] std::string line() const;
  [[nodiscard]] CommandDescription description() const;
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> result_options() const;
};

void CommandParts::check_groups() const {
  for (const auto& group : groups) {
    const auto given = std::ranges::count_if(group, [&](const auto& name) { return app->count(name) > 0; });
    if (given != 1) throw CLI::RequiredError("exactly one of " + CLI::detail::join(group, ", "));
  }
}

void CommandParts::replace_defaults() const {
  for (const auto& [option, other] : replacing)
    if (option->count() > 0 && other->option->count() == 0) other->clear();
}

void CommandParts::note_others(const std::vector<std::string>& names, const std::string& begin) {
  for (const auto& declared : options) {
    if (std::ranges::find(names, declared->name) == names.end()) continue;
    std::vector<std::string> others;
    std::ranges::copy_if(names, std::back_inserter(others), [&](const auto& name) { return name != declared->name; });
    declared->limits.push_back(begin + CLI::detail::join(others, ", "));
  }
}

bool CommandParts::prints() const {
  const CLI::Option* quiet = app->get_option_no_throw("--quiet");
  return quiet == nullptr || quiet->count() == 0;
}

std::string CommandParts::line() const {
  std::string options_text, line = call_of(name_of(app.get()));
  for (const auto& declared : options) {
    const std::string& name = declared->name;
    if (name == "--force" || (!declared->has_default && declared->option->count() == 0)) continue;
    for (const std::string& word : declared->words()) {
      std::string& text = is_positional(name) ? line : options_text;
      if (!is_positional(name)) text += " " + name;
      if (!declared->value.empty()) text += " " + quoted_where_needed(word);
    }
  }
  return line + options_text;
}

std::vector<std::pair<std::string, std::string>> CommandParts::result_options() const {
  std::vector<std::pair<std::string, std::string>> values;
  for (const auto& declared : options)
    if (declared->changes_results)
      values.emplace_back(declared->name.substr(is_positional(declared->name) ? 0 : 2), declared->compared());
  return values;
}

Option& Option::required() {
  declared_->option->required();
  return *this;
}

Option& Option::needs(const std::string& other) {
  declared_->has_default = false;  // without the other option, a command line that has it is refused
  declared_->option->needs(parts_->app->get_option(other));
  declared_->limits.push_back("Requires " + other);
  return *this;
}

Option& Option::excludes(const std::string& other) {
  declared_->option->excludes(parts_->app->get_option(other));
  declared_->limits.push_back("Not with " + other);
  return *this;
}

Option& Option::excludes_all_but(const std::vector<std::string>& others) {
  for (CLI::Option* other : parts_->app->get_options())
    if (other != declared_->option && other != parts_->app->get_help_ptr() &&
        std::ranges::find(others, other->get_name()) == others.end())
      declared_->option->excludes(other);
  declared_->limits.push_back("Only with " + CLI::detail::join(others, ", "));
  return *this;
}

Option& Option::takes(const std::string& word) {
  declared_->value = word;
  return *this;
}

Option& Option::replaces_default_of(const std::string& other) {
  const auto found = std::ranges::find(parts_->options, other, &Declared::name);
  parts_->replacing.emplace_back(declared_->option, *found);
  return *this;
}

Option& Option::changes_results(std::function<std::string()> canonical) {
  declared_->changes_results = true;
  declared_->canonical = std::move(canonical);
  return *this;
}

Command::Command(const std::string& name, const std::string& about) : parts_(std::make_shared<CommandParts>()) {
  parts_->app = std::make_shared<CLI::App>(about, name);
  parts_->app->formatter_fn([parts = parts_.get()](const CLI::App* app, const std::string&, CLI::AppFormatMode) {
    CommandDescription description = parts->description();
    description.name = name_of(app);
    return help_text(description, help_width());
  });
  // The application must not keep its own parts alive.
  parts_->app->callback([parts = parts_.get()] {
    parts->check_groups();
    parts->replace_defaults();
    if (parts->kept_line != nullptr) *parts->kept_line = parts->line();
    if (parts->kept_result_options != nullptr)
      *parts->kept_result_options = [parts] { return parts->result_options(); };
    if (!parts->run) return;
    if (parts->prints()) require_standard_output();
    parts->status = parts->run();
  });
}

Command::Command(const std::string& name, const std::string& about, const std::vector<Command>& subcommands)
    : Command(name, about) {
  parts_->subcommands = subcommands;
  parts_->app->require_subcommand(1);
  for (const Command& command : subcommands) parts_->app->add_subcommand(command.parts_->app);
}

CLI::App& Command::app() const { return *parts_->app; }

Option Command::flag(const std::string& name, bool& value, const std::string& about) {
  CLI::Option* option = app().add_flag(name, value, about);
  return parts_->declare(
      {name, option, true, "", [&value] { return value ? std::vector<std::string>{""} : std::vector<std::string>{}; }});
}

Option Command::text(const std::string& name, std::string& value, const std::string& about, const Check& check) {
  CLI::Option* option = app().add_option(name, value, about);
  const bool has_default = !value.empty();
  if (has_default) option->capture_default_str();
  if (check) option->check(check);
  return parts_->declare({name, option, has_default, "TEXT", [&value] { return std::vector{value}; }});
}

Option Command::choice(const std::string& name, std::string& value, const std::vector<std::string>& words,
                       const std::string& about) {
  CLI::Option* option = app().add_option(name, value, about)->check(one_of(words))->capture_default_str();
  return parts_->declare({name, option, true, "WORD", [&value] { return std::vector{value}; }, words});
}

Option Command::word_option(const std::string& name, const std::function<std::string()>& get,
                            const std::function<void(std::size_t)>& set, const std::vector<std::string>& words,
                            const std::string& about) {
  const auto assign = [set, words](const CLI::results_t& results) {
    set(static_cast<std::size_t>(std::ranges::find(words, results.back()) - words.begin()));
    return true;
  };
  CLI::Option* option = app().add_option(name, assign, about, true, get)->check(one_of(words));
  return parts_->declare({name, option, true, "WORD", [get] { return std::vector{get()}; }, words});
}

Option Command::names(const std::string& name, std::vector<std::string>& values, const std::string& about) {
  CLI::Option* option = app().add_option(name, values, about)->delimiter(',')->allow_extra_args(false);
  const bool has_default = !values.empty();
  if (has_default) option->capture_default_str();
  const auto words = [&values] { return values.empty() ? std::vector<std::string>{} : std::vector{joined(values)}; };
  return parts_->declare({name, option, has_default, "NAMES", words, {}, [&values] { values.clear(); }});
}

Option Command::texts(const std::string& name, std::vector<std::string>& values, const std::string& about,
                      const Check& check) {
  CLI::Option* option = app().add_option(name, values, about);
  if (!is_positional(name)) option->allow_extra_args(false);
  if (check) option->check(check);
  return parts_->declare({name, option, false, "TEXT", [&values] { return values; }});
}

Option Command::whole_number_option(const std::string& name, const std::function<std::uint64_t()>& get,
                                    const std::function<void(std::uint64_t)>& set, const std::string& about,
                                    std::uint64_t lowest, std::uint64_t highest) {
  const auto assign = [set](const CLI::results_t& results) {
    const auto number = read_whole_number(results.back());
    if (number) set(*number);
    return number.has_value();
  };
  const bool has_default = get() >= lowest && get() <= highest;
  CLI::Option* option = app().add_option(name, assign, about, has_default, [get] { return std::to_string(get()); });
  option->check(whole_number(lowest, highest), "");
  return parts_->declare({name, option, has_default, "N", [get] { return std::vector{std::to_string(get())}; }});
}

Option Command::integer(const std::string& name, int& value, const std::string& about) {
  CLI::Option* option = app().add_option(name, value, about)->capture_default_str();
  return parts_->declare({name, option, true, "N", [&value] { return std::vector{std::to_string(value)}; }});
}

Option Command::real(const std::string& name, double& value, const std::string& about, double lowest, double highest) {
  const bool has_default = value >= lowest && value <= highest;
  CLI::Option* option = app().add_option(name, value, about);
  if (has_default) option->capture_default_str();
  option->check(real_number(lowest, highest), "");
  return parts_->declare({name, option, has_default, "NUMBER", [&value] { return std::vector{shortest(value)}; }});
}

Option Command::positive(const std::string& name, double& value, const std::string& about) {
  return real(name, value, about, std::numeric_limits<double>::denorm_min());
}

void Command::require_one_of(const std::vector<std::string>& names) {
  parts_->groups.push_back(names);
  parts_->note_others(names, "Give either this or ");
}

void Command::allow_one_of(const std::vector<std::string>& names) {
  for (const std::string& name : names)
    for (const std::string& other : names)
      if (name != other) app().get_option(name)->excludes(app().get_option(other));
  parts_->note_others(names, "Not with ");
}

Option Command::seed(std::uint64_t& value, const std::string& about) { return whole("--seed", value, about); }

Option Command::threads(unsigned& value, const std::string& about) {
  constexpr unsigned kMost = 1024;
  return whole("--threads", value, about, 1, kMost);
}

Option Command::methods(std::vector<std::string>& values, const std::string& about) {
  return names("--methods", values, about);
}

Option Command::families(std::vector<std::string>& values) {
  return names("--families", values, "Families of polygons, separated by commas, or all");
}

Option Command::meshes(std::vector<std::string>& files, const std::string& about) {
  return texts("MESH", files, about, check_utf8);
}

Option Command::output(std::string& folder, const std::string& about) {
  return text("--output", folder, about).takes("FOLDER");
}

Option Command::no_pictures(bool& value) { return flag("--no-pictures", value, "Write the data only"); }

Option Command::force(bool& value) {
  const auto has = [&](const std::string& name) { return app().get_option_no_throw(name) != nullptr; };
  return flag("--force", value,
              has("--output") || has("FOLDER") ? "Overwrite what is there; without it, a folder must be empty or new"
                                               : "Overwrite existing files");
}

Option Command::json(bool& value, const std::string& about) { return flag("--json", value, about); }

Option Command::quiet(bool& value, const std::string& about) { return flag("--quiet", value, about); }

void Command::heading(const std::string& heading) { parts_->heading = heading; }

void Command::footer(const std::string& text) { parts_->footer = text; }

void Command::example(const std::string& line) { parts_->examples.push_back(line); }

void Command::runs(std::function<int()> run) { parts_->run = std::move(run); }

void Command::keep_line(std::string& line) { parts_->kept_line = &line; }

void Command::keep_result_options(std::function<std::vector<std::pair<std::string, std::string>>()>& options) {
  parts_->kept_result_options = &options;
}

void Command::writes(const std::vector<TableDescription>& tables) {
  parts_->tables.insert(parts_->tables.end(), tables.begin(), tables.end());
}

void Command::merges(std::vector<std::filesystem::path>& parts) { parts_->merged_parts = &parts; }

std::string Command::name() const { return app().get_name(); }

bool Command::has_parts() const { return parts_->merged_parts != nullptr; }

const std::vector<TableDescription>& Command::tables() const { return parts_->tables; }

const std::vector<Command>& Command::subcommands() const { return parts_->subcommands; }

CommandDescription CommandParts::description() const {
  CommandDescription description{.name = app->get_name(),
                                 .heading = heading,
                                 .about = app->get_description(),
                                 .footer = footer,
                                 .options = {},
                                 .examples = examples,
                                 .subcommands = {}};
  for (const auto& declared : options) {
    const CLI::Option& option = *declared->option;
    std::string fallback = option.get_default_str();
    // CLI11 puts lists into brackets.
    if (fallback.starts_with("[") && fallback.ends_with("]")) fallback = fallback.substr(1, fallback.size() - 2);
    description.options.push_back({.name = declared->name,
                                   .value = declared->value,
                                   .about = option.get_description(),
                                   .fallback = fallback,
                                   .words = declared->choices,
                                   .limits = declared->limits,
                                   .required = option.get_required(),
                                   .repeats = is_positional(declared->name) && option.get_expected_max() > 1});
  }
  for (const Command& command : subcommands) {
    description.subcommands.push_back(command.description());
    description.subcommands.back().name = app->get_name() + " " + command.name();
  }
  return description;
}

CommandDescription Command::description() const { return parts_->description(); }

int Command::operator()(std::vector<std::string> arguments) const {
  std::ranges::reverse(arguments);
  try {
    app().parse(arguments);
  } catch (const CLI::ParseError& error) {
    throw fault_of(&app(), error);
  }
  for (const Command& command : parts_->subcommands)
    if (command.app().parsed()) return command.parts_->status;
  return parts_->status;
}

int Command::merge(const std::vector<std::filesystem::path>& parts, const std::vector<std::string>& arguments) const {
  *parts_->merged_parts = parts;
  return (*this)(arguments);
}

CommandDescription description_of(const std::string& about, const std::vector<Command>& commands) {
  CommandDescription program{
      .name = {},
      .heading = {},
      .about = about,
      .footer =
          "Cases and the other data lie in share/touchstone beside the program's folder, or where "
          "the variable TOUCHSTONE_DATA says.",
      .options = {},
      .examples = {"help judge"},
      .subcommands = {}};
  program.options.push_back({.name = "--version",
                             .value = {},
                             .about = "Print the version, the commit and the engines",
                             .fallback = {},
                             .words = {},
                             .limits = {}});
  for (const Command& command : commands) program.subcommands.push_back(command.description());
  return program;
}

unsigned all_threads() { return std::max(1U, std::thread::hardware_concurrency()); }

namespace {

/// Refuses the first word that should name a command and does not. Without such a word, prints the help of the group.
void check_names(const CommandDescription& group, const std::vector<std::string>& arguments) {
  if (group.subcommands.empty()) return;
  if (arguments.empty()) {
    fmt::print(stderr, "{}\n", help_text(group, help_width()));
    throw UsageError("name one of these commands, such as `" + call_of(group.subcommands.front().name) + "`");
  }
  if (arguments.front().starts_with("-")) return;
  const auto named = std::ranges::find(group.subcommands, arguments.front(), &CommandDescription::word);
  if (named != group.subcommands.end()) return check_names(*named, {arguments.begin() + 1, arguments.end()});
  std::vector<std::string> known;
  for (const CommandDescription& command : group.subcommands) known.push_back(command.word());
  const std::string meant = suggestion(arguments.front(), known);
  throw UsageError((group.name.empty() ? "there is" : group.name + " has") + " no command \"" +
                   io::legible(arguments.front()) + "\"" +
                   (meant.empty() ? "; see `" + call_of(group.name) + " --help`" : meant));
}

/// Returns the words after the name of the program; `help COMMAND` is `COMMAND --help`, and --exec the name that
/// --engine had in 0.1.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  for (std::string& word : words)
    if (word == "--exec" || word.starts_with("--exec=")) word.replace(2, 4, "engine");
  if (words.empty() || words.front() != "help") return words;
  words.erase(words.begin());
  words.emplace_back("--help");
  return words;
}

}  // namespace

int run_program(const ProgramText& text, const std::vector<Command>& commands, int argc, char** argv) {
  const Command program(kProgram, text.about, commands);
  CLI::App& app = program.app();
  app.set_version_flag("--version", text.version);
  app.formatter_fn([&](const CLI::App*, const std::string&, CLI::AppFormatMode) {
    return help_text(description_of(text.about, commands), help_width());
  });
  std::vector<std::string> words = words_of(argc, argv);
  check_names(description_of(text.about, commands), words);
  std::ranges::reverse(words);
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success)) throw fault_of(&app, error);
    return app.exit(error);
  }
  for (const Command& command : commands) {
    if (!command.app().parsed()) continue;
    for (const Command& sub : command.parts_->subcommands)
      if (sub.app().parsed()) return sub.parts_->status;
    return command.parts_->status;
  }
  return 0;
}

}  // namespace touchstone::run
