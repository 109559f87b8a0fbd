// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/verdict.h"
#include "experiments/judge/regress/regress.h"
#include "experiments/methods/registry.h"
#include "experiments/program/command_run.h"
#include "experiments/program/output.h"
#include "experiments/program/printing.h"
#include "experiments/program/statistics/shares.h"
#include "experiments/program/table.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::commands {
namespace {

using namespace regress;

struct Options : program::FolderOptions {
  std::string baseline, write;
  methods::Selection methods{{"all"}};
  bool allow_missing = false;
  Settings settings;
  unsigned threads = program::all_threads();
};

std::string cell(const Summary& summary) {
  if (summary.wrong == 0) return "-";
  return fmt::format("{}{}", statistics::percent_to_digits(statistics::share_of(summary.wrong, summary.cases), 2),
                     summary.first ? fmt::format(" 2^-{}", *summary.first) : "");
}

std::string table_of(const OutcomeTable& table, const Settings& settings, Numbers numbers) {
  std::string text = fmt::format(
      "Wrong answers in % of {} cases a family, of {}, and the largest relative offset of the radius at which one was "
      "found\n(-: none, at 95 % confidence at most {:.2g} % of such cases)\n{:<24}",
      settings.cases(), to_string(numbers), 300.0 / static_cast<double>(settings.cases()), "method");
  for (const auto family : workloads::all_families()) text += fmt::format("{:>14}", to_string(family));
  text += "\n";
  for (const auto& [method, groups] : table) {
    text += fmt::format("{:<24}", method);
    std::size_t unsure = 0;
    for (const auto family : workloads::all_families()) {
      const Summary summary = summary_of(groups.at(Group{family, numbers}.name()), numbers);
      text += fmt::format("{:>14}", cell(summary));
      unsure += summary.unsure;
    }
    text += unsure > 0 ? fmt::format("   and unsure about {} in all\n", unsure) : "\n";
  }
  return text;
}

struct OutcomeRow {
  std::string_view method;
  Group group;
  Summary summary;
};

const program::Table<OutcomeRow>& outcomes_csv() {
  using program::path;
  static const program::Table<OutcomeRow> table(
      "outcomes.csv", "a method, numbers and a family",
      {{"method", "the method", &OutcomeRow::method},
       {"numbers", "what the coordinates and radii are: doubles or floats", path(&OutcomeRow::group, &Group::numbers)},
       {"family", "the family of polygons", path(&OutcomeRow::group, &Group::family)},
       {"wrong", "cases with a wrong answer", path(&OutcomeRow::summary, &Summary::wrong)},
       {"unsure", "cases that the method does not decide", path(&OutcomeRow::summary, &Summary::unsure)},
       {"cases", "cases", path(&OutcomeRow::summary, &Summary::cases)},
       {"first_offset_exponent", "the least k for which the method is wrong at 2^-k of the distance",
        path(&OutcomeRow::summary, &Summary::first)}});
  return table;
}

std::vector<OutcomeRow> rows_of(const OutcomeTable& table) {
  std::vector<OutcomeRow> rows;
  for (const auto& [method, groups] : table)
    for (const Group& group : all_groups())
      rows.push_back({method, group, summary_of(groups.at(group.name()), group.numbers)});
  return rows;
}

/// Returns the cases for which methods have become worse, each once, in the form that the judge reads.
std::string worse_text(const Settings& settings, const std::vector<Change>& changes) {
  std::string text;
  for (const Group& group : all_groups()) {
    std::map<std::size_t, std::vector<std::string>> cases;
    for (const Change& change : changes)
      if (change.group.name() == group.name())
        for (const std::size_t n : change.worse) cases[n].push_back("fails:" + change.method);
    for (const auto& [n, tags] : cases) {
      const auto sample = draw_case(settings, group, n);
      const cases::Shapes shapes{sample.question(), sample.polygon};
      text += cases::case_line(sample.id, shapes, tags, exact_answer(shapes));
    }
  }
  return text;
}

/// Prints which methods only one of both has.
void tell_missing(const Baseline& baseline, const OutcomeTable& table) {
  for (const auto& [method, groups] : baseline.table)
    if (table.count(method) == 0) fmt::print("{}: in the baseline, not in this run\n", io::legible(method));
  for (const auto& [method, groups] : table)
    if (baseline.table.count(method) == 0) fmt::print("{}: not in the baseline\n", method);
}

/// Prints the changes.
void tell_changes(const std::vector<Change>& changes) {
  std::size_t better = 0, worse = 0;
  for (const Change& change : changes) {
    fmt::print("{} on {}: {} better, {} worse", change.method, change.group.name(), change.better.size(),
               change.worse.size());
    constexpr std::size_t kMost = 5;
    for (std::size_t i = 0; i < std::min(kMost, change.worse.size()); ++i)
      fmt::print("{}{}", i == 0 ? ": cases " : ", ", change.worse[i]);
    fmt::print("{}\n", change.worse.size() > kMost ? ", ..." : "");
    better += change.better.size();
    worse += change.worse.size();
  }
  fmt::print("{} better than the baseline, {} worse\n", program::counted(better, "case"), worse);
}

/// Returns whether the command line names the method, rather than `all`.
bool is_named(const Options& options, const cases::Method& method) {
  const auto& [names, engines] = options.methods;
  return std::ranges::find(names, method.name()) != names.end() ||
         std::ranges::any_of(engines, [&](const auto& text) { return methods::engine_of(text).name == method.name(); });
}

/// Throws if no method could be compared with the baseline, or a method that the command line names could not.
void refuse_missing(const Options& options, const Baseline& baseline,
                    const std::vector<const cases::Method*>& methods) {
  const auto has = [&](std::string_view method) { return baseline.table.count(std::string(method)) > 0; };
  if (std::ranges::none_of(methods, [&](const cases::Method* method) { return has(method->name()); }))
    throw std::runtime_error(options.baseline + ": has none of the methods of this run");
  if (options.allow_missing) return;
  for (const cases::Method* method : methods)
    if (is_named(options, *method) && !has(method->name()))
      throw std::runtime_error(fmt::format("{}: has no method {}, which {} names; --allow-missing continues without it",
                                           options.baseline, method->name(),
                                           method->through_pipe() ? "--engine" : "--methods"));
}

int run(const Options& options) {
  auto methods = options.methods.methods();
  std::erase_if(methods, [&](const cases::Method* method) {
    if (answers(*method)) return false;
    if (!options.quiet) fmt::print("{}: does not decide contact; left out\n", method->name());
    return true;
  });
  std::optional<Baseline> baseline;
  if (!options.baseline.empty()) baseline = read_baseline(options.baseline);
  if (baseline) refuse_missing(options, *baseline, methods);
  const Settings settings = baseline ? baseline->settings : options.settings;
  program::CommandRun run(options);
  if (!options.write.empty()) {
    program::refuse_overwrite(options.write, options.force);
    program::make_folder(std::filesystem::absolute(options.write).parent_path());
  }

  std::optional<OutcomeTable> table;
  {
    program::ProgressLine line = run.progress("regress", blocks_of(settings));
    table = find_outcomes(settings, methods, options.threads, run.stop(), std::ref(line));
  }
  if (!table) return run.finish_unwritten();
  program::print_result(
      table_of(*table, settings, Numbers::Doubles) + "\n" + table_of(*table, settings, Numbers::Floats) + "\n",
      options.quiet);

  std::vector<Change> changed;
  if (baseline) {
    if (!options.quiet) tell_missing(*baseline, *table);
    changed = changes(baseline->table, *table);
    if (!options.quiet) tell_changes(changed);
  }
  const bool worse = std::ranges::any_of(changed, [](const Change& change) { return !change.worse.empty(); });
  if (!options.write.empty()) program::write_file(options.write, baseline_text({settings, *table}), options.force);
  if (run.has_folder()) {
    outcomes_csv().write(run.folder(), rows_of(*table));
    program::write_file(run.folder() / "worse.jsonl", worse_text(settings, changed));
    run.write_record({.seed = settings.seed,
                      .samples_asked = settings.samples,
                      .samples_done = settings.samples,
                      .threads = options.threads});
  }
  return worse ? 1 : 0;
}

}  // namespace

program::Command regress_command() {
  program::Command command("regress", "Compare the failures of every method with a baseline");
  auto options = std::make_shared<Options>();
  command.help().footer =
      "Tests the methods with balls near a face, an edge and a vertex of random polygons, with radii at relative "
      "offsets of 2^-8 to 2^-52 from the exact distance; then with as many cases whose coordinates and radii are floats, "
      "at offsets of 2^-8 to 2^-23. Cases are a function of the seed, so that the change of a single answer is noticed. "
      "Exit status 1 if a method does worse on a case than in the baseline: wrong instead of right or unsure, or unsure "
      "instead of right; 2 if the baseline cannot be read or lacks a method that --methods or --engine names, or if "
      "--write names an existing file without --force.";
  command.text("--baseline", options->baseline, "The baseline to compare with; its seed and samples are used")
      .takes("FILE");
  command
      .flag("--allow-missing", options->allow_missing,
            "A method that --methods or --engine names may be missing from the baseline; it is then not compared")
      .needs("--baseline");
  command.text("--write", options->write, "Write the outcomes as a baseline").takes("FILE");
  methods::declare_methods(command, options->methods);
  program::declare_seed(command, options->settings.seed).excludes("--baseline");
  command
      .whole("--samples", options->settings.samples, "Of each family of polygons and place of the ball", 1,
             kMostSamples)
      .excludes("--baseline");
  program::declare_threads(command, options->threads);
  program::declare_output(
      command, *options,
      "Folder for outcomes.csv, worse.jsonl (cases that have become worse, for `judge`) and run.json");
  program::declare_quiet(command, options->quiet, "Print no table, no changes and no progress; the exit status tells");
  command.writes({outcomes_csv().description()});
  command.help().examples.emplace_back(
      "regress --baseline tests/experiments/judge/regress/baseline.json --methods fast,thesis");
  command.runs([options] { return run(*options); });
  return command;
}

}  // namespace touchstone::commands
