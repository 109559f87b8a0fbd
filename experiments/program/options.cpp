// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <iterator>
#include <thread>

#include "experiments/program/command.h"
#include "experiments/program/command_parts.h"
#include "experiments/program/json.h"
#include "experiments/program/words.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::program {
namespace {

/// Returns the shortest text that reads back as the same number.
std::string shortest(double number) {
  std::array<char, 32> text;
  return {text.begin(), std::to_chars(text.begin(), text.end(), number).ptr};
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
  return is_utf8(name) ? "" : "the name of a file is not UTF-8: " + io::legible(name);
}

}  // namespace

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

CLI::App& OptionList::app() const { return *parts_->app; }

Option OptionList::flag(const std::string& name, bool& value, const std::string& about) {
  CLI::Option* option = app().add_flag(name, value, about);
  return parts_->declare(
      {name, option, true, "", [&value] { return value ? std::vector<std::string>{""} : std::vector<std::string>{}; }});
}

Option OptionList::text(const std::string& name, std::string& value, const std::string& about, const Check& check) {
  CLI::Option* option = app().add_option(name, value, about);
  const bool has_default = !value.empty();
  if (has_default) option->capture_default_str();
  if (check) option->check(check);
  return parts_->declare({name, option, has_default, "TEXT", [&value] { return std::vector{value}; }});
}

Option OptionList::choice(const std::string& name, std::string& value, const std::vector<std::string>& words,
                          const std::string& about) {
  CLI::Option* option = app().add_option(name, value, about)->check(one_of(words))->capture_default_str();
  return parts_->declare({name, option, true, "WORD", [&value] { return std::vector{value}; }, words});
}

Option OptionList::word_option(const std::string& name, const std::function<std::string()>& get,
                               const std::function<void(std::size_t)>& set, const std::vector<std::string>& words,
                               const std::string& about) {
  const auto assign = [set, words](const CLI::results_t& results) {
    set(static_cast<std::size_t>(std::ranges::find(words, results.back()) - words.begin()));
    return true;
  };
  CLI::Option* option = app().add_option(name, assign, about, true, get)->check(one_of(words));
  return parts_->declare({name, option, true, "WORD", [get] { return std::vector{get()}; }, words});
}

Option OptionList::names(const std::string& name, std::vector<std::string>& values, const std::string& about) {
  CLI::Option* option = app().add_option(name, values, about)->delimiter(',')->allow_extra_args(false);
  const bool has_default = !values.empty();
  if (has_default) option->capture_default_str();
  const auto words = [&values] { return values.empty() ? std::vector<std::string>{} : std::vector{joined(values)}; };
  return parts_->declare({name, option, has_default, "NAMES", words, {}, [&values] { values.clear(); }});
}

Option OptionList::texts(const std::string& name, std::vector<std::string>& values, const std::string& about,
                         const Check& check) {
  CLI::Option* option = app().add_option(name, values, about);
  if (!is_positional(name)) option->allow_extra_args(false);
  if (check) option->check(check);
  return parts_->declare({name, option, false, "TEXT", [&values] { return values; }});
}

Option OptionList::whole_number_option(const std::string& name, const std::function<std::uint64_t()>& get,
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

Option OptionList::integer(const std::string& name, int& value, const std::string& about) {
  CLI::Option* option = app().add_option(name, value, about)->capture_default_str();
  return parts_->declare({name, option, true, "N", [&value] { return std::vector{std::to_string(value)}; }});
}

Option OptionList::real(const std::string& name, double& value, const std::string& about, double lowest,
                        double highest) {
  const bool has_default = value >= lowest && value <= highest;
  CLI::Option* option = app().add_option(name, value, about);
  if (has_default) option->capture_default_str();
  option->check(real_number(lowest, highest), "");
  return parts_->declare({name, option, has_default, "NUMBER", [&value] { return std::vector{shortest(value)}; }});
}

Option declare_positive(OptionList& options, const std::string& name, double& value, const std::string& about) {
  return options.real(name, value, about, std::numeric_limits<double>::denorm_min());
}

void require_one_of(OptionList& options, const std::vector<std::string>& names) {
  options.parts().groups.push_back(names);
  for (const auto& declared : options.parts().options) {
    if (std::ranges::find(names, declared->name) == names.end()) continue;
    std::vector<std::string> others;
    std::ranges::copy_if(names, std::back_inserter(others), [&](const auto& name) { return name != declared->name; });
    declared->limits.push_back("Give either this or " + CLI::detail::join(others, ", "));
  }
}

Option declare_seed(OptionList& options, std::uint64_t& value, const std::string& about) {
  return options.whole("--seed", value, about);
}

Option declare_threads(OptionList& options, unsigned& value, const std::string& about) {
  return options.whole("--threads", value, about, 1, 1024);
}

Option declare_methods(OptionList& options, std::vector<std::string>& values, const std::string& about) {
  return options.names("--methods", values, about);
}

Option declare_families(OptionList& options, std::vector<std::string>& values) {
  return options.names("--families", values, "Families of polygons, separated by commas, or all");
}

Option declare_meshes(OptionList& options, std::vector<std::string>& files, const std::string& about) {
  return options.texts("MESH", files, about, check_utf8);
}

Option declare_folder(OptionList& options, std::string& folder, const std::string& about) {
  return options.text("--output", folder, about).takes("FOLDER");
}

Option declare_no_pictures(OptionList& options, bool& value) {
  return options.flag("--no-pictures", value, "Write the data only");
}

Option declare_force(OptionList& options, bool& value) {
  const auto has = [&](const std::string& name) { return options.parts().app->get_option_no_throw(name) != nullptr; };
  return options.flag("--force", value,
                      has("--output") || has("FOLDER")
                          ? "Overwrite what is there; without it, a folder must be empty or new"
                          : "Overwrite existing files");
}

Option declare_json(OptionList& options, bool& value, const std::string& about) {
  return options.flag("--json", value, about);
}

Option declare_quiet(OptionList& options, bool& value, const std::string& about) {
  return options.flag("--quiet", value, about);
}

std::string joined(const std::vector<std::string>& words) { return CLI::detail::join(words, ","); }

unsigned all_threads() { return std::max(1U, std::thread::hardware_concurrency()); }

}  // namespace touchstone::program
