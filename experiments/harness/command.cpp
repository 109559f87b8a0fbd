// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/harness/command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "experiments/harness/real_number.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/similar_words.h"
#include "experiments/harness/standard_output.h"
#include "experiments/harness/whole_number.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::harness {
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

/// Returns a suggestion for the first word that no option of the command has, if it is an option itself.
std::string suggested_option(const CLI::App* app) {
  const auto words = app->remaining(true);
  const auto unknown = std::ranges::find_if(words, [](const std::string& word) { return word.starts_with("-"); });
  while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
  if (unknown == words.end()) return {};
  std::vector<std::string> known;
  for (const CLI::Option* option : app->get_options()) known.push_back(option->get_name());
  return suggestion(*unknown, known);
}

/// Makes an error about the command line printable: it may quote the command line.
std::string legible_complaint(const CLI::App* app, const CLI::Error& error) {
  const bool is_unknown = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  const std::string sentence = io::all_legible(error.what() + (is_unknown ? suggested_option(app) : ""));
  return CLI::FailureMessage::simple(app, CLI::Error(error.get_name(), sentence, error.get_exit_code()));
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

/// An option, and the words of its value as the command line would hold them; empty if it has no value.
struct Declared {
  std::string name;
  CLI::Option* option;
  bool has_default, takes_value;
  std::function<std::vector<std::string>()> words;
  std::vector<std::string> choices{};  ///< the only values, if they are listed
  std::function<void()> clear{};       ///< empties the value
  bool changes_results = false;
  std::function<std::string()> canonical{};

  /// Returns the value that is compared when a run continues another one.
  [[nodiscard]] std::string value() const { return canonical ? canonical() : joined(words()); }
};

struct CommandParts {
  std::shared_ptr<CLI::App> app;
  std::vector<std::shared_ptr<Declared>> options;
  std::function<int()> run;
  std::string* kept_line = nullptr;
  std::vector<TableDescription>* kept_tables = nullptr;
  std::function<std::vector<std::pair<std::string, std::string>>()>* kept_result_options = nullptr;
  std::vector<TableDescription> tables;
  std::vector<Command> subcommands;
  std::vector<std::vector<std::string>> groups;  ///< exactly one option of each is required
  /// Options, and those whose defaults they replace.
  std::vector<std::pair<const CLI::Option*, std::shared_ptr<Declared>>> replacing{};
  std::string footer{};
  std::vector<std::string> examples{};
  int status = 0;

  Option declare(Declared declared) {
    options.push_back(std::make_shared<Declared>(std::move(declared)));
    return Option(*this, options.back());
  }
  void check_groups() const;
  void replace_defaults() const;
  void show_footer() const;
  /// Returns whether the command prints, for all it was told.
  [[nodiscard]] bool prints() const;
  [[nodiscard]] std::string line() const;
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> result_options() const;
};

void CommandParts::check_groups() const {
  for (const auto& group : groups) {
    const auto given = std::ranges::count_if(group, [&](const auto& name) { return app->count(name) > 0; });
    if (given != 1) throw CLI::RequiredError::Option(1, 1, static_cast<std::size_t>(given), CLI::detail::join(group));
  }
}

void CommandParts::replace_defaults() const {
  for (const auto& [option, other] : replacing)
    if (option->count() > 0 && other->option->count() == 0) other->clear();
}

void CommandParts::show_footer() const {
  std::string text = footer.empty() ? "" : "\n" + footer + "\n";
  if (!examples.empty()) text += examples.size() == 1 ? "\nExample:" : "\nExamples:";
  for (const std::string& example : examples) text += "\n  " + kProgram + " " + example;
  app->footer(text);
}

bool CommandParts::prints() const {
  const CLI::Option* quiet = app->get_option_no_throw("--quiet");
  return quiet == nullptr || quiet->count() == 0;
}

std::string CommandParts::line() const {
  std::string line, options_text;
  for (const CLI::App* of = app.get(); of != nullptr && of->get_name() != kProgram; of = of->get_parent())
    line = " " + of->get_name() + line;
  line = kProgram + line;
  for (const auto& declared : options) {
    const auto& [name, option, has_default, takes_value, words, choices, clear, changes_results, canonical] = *declared;
    if (name == "--force" || (!has_default && option->count() == 0)) continue;
    for (const std::string& word : words()) {
      std::string& text = is_positional(name) ? line : options_text;
      if (!is_positional(name)) text += " " + name;
      if (takes_value) text += " " + quoted_where_needed(word);
    }
  }
  return line + options_text;
}

std::vector<std::pair<std::string, std::string>> CommandParts::result_options() const {
  std::vector<std::pair<std::string, std::string>> values;
  for (const auto& declared : options)
    if (declared->changes_results) values.emplace_back(declared->name.substr(2), declared->value());
  return values;
}

Option& Option::required() {
  declared_->option->required();
  return *this;
}

Option& Option::needs(const std::string& other) {
  declared_->option->needs(parts_->app->get_option(other));
  return *this;
}

Option& Option::excludes(const std::string& other) {
  declared_->option->excludes(parts_->app->get_option(other));
  return *this;
}

Option& Option::excludes_all_but(const std::vector<std::string>& others) {
  for (CLI::Option* other : parts_->app->get_options())
    if (other != declared_->option && other != parts_->app->get_help_ptr() &&
        std::ranges::find(others, other->get_name()) == others.end())
      declared_->option->excludes(other);
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
  // The application must not keep its own parts alive.
  parts_->app->callback([parts = parts_.get()] {
    parts->check_groups();
    parts->replace_defaults();
    if (parts->kept_line != nullptr) *parts->kept_line = parts->line();
    if (parts->kept_tables != nullptr) *parts->kept_tables = parts->tables;
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
  return parts_->declare({name, option, true, false,
                          [&value] { return value ? std::vector<std::string>{""} : std::vector<std::string>{}; }});
}

Option Command::text(const std::string& name, std::string& value, const std::string& about, const Check& check) {
  CLI::Option* option = app().add_option(name, value, about);
  const bool has_default = !value.empty();
  if (has_default) option->capture_default_str();
  if (check) option->check(check);
  return parts_->declare({name, option, has_default, true, [&value] { return std::vector{value}; }});
}

Option Command::choice(const std::string& name, std::string& value, const std::vector<std::string>& words,
                       const std::string& about) {
  CLI::Option* option = app().add_option(name, value, about)->check(CLI::IsMember(words))->capture_default_str();
  return parts_->declare({name, option, true, true, [&value] { return std::vector{value}; }, words});
}

Option Command::word_option(const std::string& name, const std::function<std::string()>& get,
                            const std::function<void(std::size_t)>& set, const std::vector<std::string>& words,
                            const std::string& about) {
  const auto assign = [set, words](const CLI::results_t& results) {
    set(static_cast<std::size_t>(std::ranges::find(words, results.back()) - words.begin()));
    return true;
  };
  CLI::Option* option = app().add_option(name, assign, about, true, get)->check(CLI::IsMember(words));
  return parts_->declare({name, option, true, true, [get] { return std::vector{get()}; }, words});
}

Option Command::names(const std::string& name, std::vector<std::string>& values, const std::string& about) {
  CLI::Option* option = app().add_option(name, values, about)->delimiter(',')->allow_extra_args(false);
  const bool has_default = !values.empty();
  if (has_default) option->capture_default_str();
  const auto words = [&values] { return values.empty() ? std::vector<std::string>{} : std::vector{joined(values)}; };
  return parts_->declare({name, option, has_default, true, words, {}, [&values] { values.clear(); }});
}

Option Command::texts(const std::string& name, std::vector<std::string>& values, const std::string& about,
                      const Check& check) {
  CLI::Option* option = app().add_option(name, values, about);
  if (!is_positional(name)) option->allow_extra_args(false);
  if (check) option->check(check);
  return parts_->declare({name, option, false, true, [&values] { return values; }});
}

Option Command::whole_number_option(const std::string& name, const std::function<std::uint64_t()>& get,
                                    const std::function<void(std::uint64_t)>& set, const std::string& about,
                                    std::uint64_t lowest, std::uint64_t highest) {
  const auto assign = [set](const CLI::results_t& results) {
    const std::string& text = results.back();
    std::uint64_t number = 0;
    const bool read = std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc();
    if (read) set(number);
    return read;
  };
  const bool has_default = get() >= lowest && get() <= highest;
  CLI::Option* option = app().add_option(name, assign, about, has_default, [get] { return std::to_string(get()); });
  option->type_name("UINT")->check(whole_number(lowest, highest), "");
  return parts_->declare({name, option, has_default, true, [get] { return std::vector{std::to_string(get())}; }});
}

Option Command::integer(const std::string& name, int& value, const std::string& about) {
  CLI::Option* option = app().add_option(name, value, about)->capture_default_str();
  return parts_->declare({name, option, true, true, [&value] { return std::vector{std::to_string(value)}; }});
}

Option Command::real(const std::string& name, double& value, const std::string& about, double lowest, double highest) {
  const bool has_default = value >= lowest && value <= highest;
  CLI::Option* option = app().add_option(name, value, about);
  if (has_default) option->capture_default_str();
  option->check(real_number(lowest, highest), "");
  return parts_->declare({name, option, has_default, true, [&value] { return std::vector{shortest(value)}; }});
}

Option Command::positive(const std::string& name, double& value, const std::string& about) {
  Option option = real(name, value, about, std::numeric_limits<double>::denorm_min());
  return option;
}

// A group of CLI11's would do, but help prints its options below all others, or not at all if it has no name.
void Command::require_one_of(const std::vector<std::string>& names) { parts_->groups.push_back(names); }

void Command::allow_one_of(const std::vector<std::string>& names) {
  for (const std::string& name : names)
    for (const std::string& other : names)
      if (name != other) app().get_option(name)->excludes(app().get_option(other));
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
  return texts("MESH", files, about, check_utf8).required();
}

Option Command::output(std::string& folder, const std::string& about) { return text("--output", folder, about); }

Option Command::no_pictures(bool& value) { return flag("--no-pictures", value, "Write the data only"); }

Option Command::resume(bool& value) {
  return flag("--resume", value, "Continue the run that was stopped or killed in that folder");
}

Option Command::force(bool& value) {
  Option option = flag("--force", value, "Overwrite what is there; without it, a folder must be empty or new");
  if (app().get_option_no_throw("--resume") != nullptr) option.excludes("--resume");
  return option;
}

Option Command::json(bool& value, const std::string& about) { return flag("--json", value, about); }

Option Command::quiet(bool& value, const std::string& about) { return flag("--quiet", value, about); }

void Command::footer(const std::string& text) {
  parts_->footer = text;
  parts_->show_footer();
}

void Command::example(const std::string& line) {
  parts_->examples.push_back(line);
  parts_->show_footer();
}

void Command::runs(std::function<int()> run) { parts_->run = std::move(run); }

void Command::keep_line(std::string& line) { parts_->kept_line = &line; }

void Command::keep_result_options(std::function<std::vector<std::pair<std::string, std::string>>()>& options) {
  parts_->kept_result_options = &options;
}

void Command::keep_tables(std::vector<TableDescription>& tables) { parts_->kept_tables = &tables; }

void Command::writes(const std::vector<TableDescription>& tables) {
  parts_->tables.insert(parts_->tables.end(), tables.begin(), tables.end());
}

std::string Command::name() const { return app().get_name(); }

const std::vector<TableDescription>& Command::tables() const { return parts_->tables; }

const std::vector<Command>& Command::subcommands() const { return parts_->subcommands; }

CommandDescription Command::description() const {
  CommandDescription description{.name = name(),
                                 .about = app().get_description(),
                                 .footer = parts_->footer,
                                 .options = {},
                                 .examples = {},
                                 .subcommands = {}};
  description.examples = parts_->examples;
  for (const auto& declared : parts_->options) {
    const CLI::Option& option = *declared->option;
    description.options.push_back({.name = declared->name,
                                   .value = declared->takes_value ? option.get_type_name() : "",
                                   .about = option.get_description(),
                                   .fallback = option.get_default_str(),
                                   .words = declared->choices,
                                   .required = option.get_required()});
  }
  for (const Command& command : parts_->subcommands) {
    description.subcommands.push_back(command.description());
    description.subcommands.back().name = name() + " " + command.name();
  }
  return description;
}

int Command::operator()(std::vector<std::string> arguments) const {
  std::ranges::reverse(arguments);
  try {
    app().parse(arguments);
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  for (const Command& command : parts_->subcommands)
    if (command.app().parsed()) return command.parts_->status;
  return parts_->status;
}

unsigned all_threads() { return std::max(1U, std::thread::hardware_concurrency()); }

namespace {

/// Refuses the first word that should name a command and does not.
void check_names(const std::vector<Command>& commands, const std::vector<std::string>& arguments,
                 const std::string& group = kProgram) {
  if (arguments.empty() || arguments.front().starts_with("-")) return;
  const auto named = std::ranges::find(commands, arguments.front(), &Command::name);
  if (named == commands.end()) {
    std::vector<std::string> known;
    for (const Command& command : commands) known.push_back(command.name());
    const std::string meant = suggestion(arguments.front(), known);
    throw UsageError(group + " has no command \"" + io::legible(arguments.front()) + "\"" +
                     (meant.empty() ? "; `" + group + " --help` lists them" : meant));
  }
  if (!named->subcommands().empty())
    check_names(named->subcommands(), {arguments.begin() + 1, arguments.end()}, group + " " + named->name());
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
  app.failure_message(legible_complaint);
  std::vector<std::string> words = words_of(argc, argv);
  check_names(commands, words);
  std::ranges::reverse(words);
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    constexpr int kWrongInput = 2;
    return app.exit(error) == 0 ? 0 : kWrongInput;
  }
  for (const Command& command : commands) {
    if (!command.app().parsed()) continue;
    for (const Command& sub : command.parts_->subcommands)
      if (sub.app().parsed()) return sub.parts_->status;
    return command.parts_->status;
  }
  return 0;
}

}  // namespace touchstone::harness
