// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "experiments/methods/registry.h"
#include "experiments/program/output.h"
#include "experiments/program/printing.h"
#include "experiments/program/statistics/shares.h"
#include "experiments/program/study.h"
#include "experiments/program/table.h"
#include "experiments/studies/stability/measure.h"
#include "experiments/studies/stability/onset.h"

namespace touchstone::stability {
namespace {

using program::path;

/// Returns the columns `axis`, `level` and `value` of a row with an axis and a level.
template <class Row>
std::vector<program::Column<Row>> level_columns() {
  const auto level = [](const Row& row) -> const Level& { return levels(row.axis)[row.level]; };
  return {{"axis", "the property that gets worse", &Row::axis},
          {"level", "how bad it is, as tables name it", [level](const Row& row) { return level(row).name; }},
          {"value", "the same as a number", [level](const Row& row) { return level(row).value; }, "{:.6g}"}};
}

struct FailureRow {
  Axis axis;
  std::size_t level;
  Nearness nearness;
  Test test;
  std::string_view method;
  const SampledFailures* failures;
  program::Rate rate;
};

const program::Table<FailureRow>& failures_table() {
  using cases::Failures;
  const auto of_samples = [](auto number) {
    return path(&FailureRow::failures, path(&SampledFailures::samples, number));
  };
  const auto of_answers = [](auto number) {
    return path(&FailureRow::failures, path(&SampledFailures::answers, number));
  };
  static const program::Table<FailureRow> table(
      "failures.csv", "an axis, level, nearness, test and method",
      program::all_columns<FailureRow>(
          {level_columns<FailureRow>(),
           {{"nearness", "how close the ball's radius is to the exact distance", &FailureRow::nearness},
            {"test", "the decision that is compared", &FailureRow::test},
            {"method", "the method", &FailureRow::method},
            {"failed_samples", "polygons with a wrong answer", of_samples(&Failures::wrong)},
            {"samples", "polygons", of_samples(&Failures::trials)}},
           program::rate_columns<FailureRow>("failed samples", &FailureRow::rate),
           {{"wrong_answers", "wrong answers", of_answers(&Failures::wrong)},
            {"answers", "answers", of_answers(&Failures::trials)}}}));
  return table;
}

struct FirstFailureRow {
  Axis axis;
  Nearness nearness;
  Test test;
  std::string_view method;
  std::optional<std::string_view> first, before;
  std::optional<std::uint64_t> samples_before;
  cases::Failures all;  ///< samples of all levels
  program::Rate rate;
};

const program::Table<FirstFailureRow>& first_failure_table() {
  using Row = FirstFailureRow;
  const auto upper = [](std::uint64_t samples) { return statistics::clopper_pearson(0, samples).upper; };
  static const program::Table<Row> table(
      "first-failure.csv", "an axis, nearness, test and method",
      program::all_columns<Row>(
          {{{"axis", "the property that gets worse", &Row::axis},
            {"nearness", "how close the ball's radius is to the exact distance", &Row::nearness},
            {"test", "the decision that is compared", &Row::test},
            {"method", "the method", &Row::method},
            {"first_failure", "the first level with a failure", &Row::first},
            {"level_before", "the level before the first failure; the last one if there was none", &Row::before},
            {"samples_before", "samples there", &Row::samples_before},
            {"upper_before", "the upper limit of their rate of failures",
             [upper](const Row& row) {
               return row.samples_before ? std::optional(upper(*row.samples_before)) : std::nullopt;
             },
             "{:.6g}"},
            {"failed_samples", "failed samples of all levels", path(&Row::all, &cases::Failures::wrong)},
            {"samples", "samples of all levels", path(&Row::all, &cases::Failures::trials)}},
           program::rate_columns<Row>("failed samples of all levels", &Row::rate)}));
  return table;
}

struct ErrorRow {
  Axis axis;
  std::size_t level;
  Quantity quantity;
  std::string_view method;
  const statistics::Distribution* errors;
};

const program::Table<ErrorRow>& errors_table() {
  constexpr const char* kFormat = "{:.4g}";
  const auto quantile = [](double share) {
    return [share](const ErrorRow& row) { return row.errors->quantile(share); };
  };
  static const program::Table<ErrorRow> table(
      "errors.csv", "an axis, level, quantity and method",
      program::all_columns<ErrorRow>(
          {level_columns<ErrorRow>(),
           {{"quantity", "distance or point", &ErrorRow::quantity},
            {"method", "the method", &ErrorRow::method},
            {"numbers", "numbers", path(&ErrorRow::errors, &statistics::Distribution::count)},
            {"not_finite", "numbers that are not finite", path(&ErrorRow::errors, &statistics::Distribution::infinite)},
            {"relative_median", "the median of the relative error", quantile(0.5), kFormat},
            {"relative_99", "the 99 % quantile", quantile(0.99), kFormat},
            {"relative_max", "the maximum", path(&ErrorRow::errors, &statistics::Distribution::largest), kFormat}}}));
  return table;
}

void write_failures(const std::filesystem::path& folder, const Settings& settings, const Summary& summary) {
  std::vector<FailureRow> rows;
  std::vector<FirstFailureRow> firsts;
  for (const Axis axis : settings.axes)
    for (const Nearness nearness : kNearnesses)
      for (const Test test : kCountedTests)
        for (std::size_t m = 0; m < settings.methods.size(); ++m) {
          const std::string_view name = settings.methods[m]->name();
          FirstFailureRow first{axis, nearness, test, name, {}, {}, {}, {}, {}};
          for (std::size_t level = 0; level < levels(axis).size(); ++level) {
            const SampledFailures* failures = summary.at(axis, nearness, test, m, level);
            if (failures == nullptr) continue;
            rows.push_back({axis, level, nearness, test, name, failures, failures->samples.rate()});
            program::add(first.all, failures->samples);
            if (first.first) continue;
            if (failures->samples.wrong > 0)
              first.first = levels(axis)[level].name;
            else
              first.before = levels(axis)[level].name, first.samples_before = failures->samples.trials;
          }
          if (first.all.trials == 0) continue;
          first.rate = first.all.rate();
          firsts.push_back(first);
        }
  failures_table().write(folder, rows);
  first_failure_table().write(folder, firsts);
}

void write_errors(const std::filesystem::path& folder, const Settings& settings, const Summary& summary) {
  std::vector<ErrorRow> rows;
  for (const auto& [cell, errors] : summary.errors) {
    const auto& [axis, quantity, method, level] = cell;
    rows.push_back({axis, level, quantity, settings.methods[method]->name(), &errors});
  }
  errors_table().write(folder, rows);
}

/// Writes worst.jsonl: the worst case of each axis and method, as `touchstone judge --methods NAME` takes it; the
/// method is its first tag. Axes that compare with an intended motion and those of the floating-point mode have none.
void write_worst(const std::filesystem::path& folder, const Summary& summary) {
  std::vector<const WorstCase*> cases;
  for (const auto& [place, worst] : summary.worst) cases.push_back(&worst);
  std::ranges::stable_sort(cases, [](const WorstCase* a, const WorstCase* b) {
    return a->rank != b->rank ? a->rank > b->rank : a->error > b->error;
  });
  std::string text;
  for (const WorstCase* worst : cases) text += worst->line;
  program::write_file(folder / "worst.jsonl", text);
}

/// Returns the first level of each axis at which each method's contact was wrong, by the nearness of the ball.
std::string first_failures(const Settings& settings, const Summary& summary) {
  std::vector<std::vector<std::string>> lines{{"axis", "nearness"}};
  for (const auto* method : settings.methods) lines.front().emplace_back(method->name());
  for (const Axis axis : settings.axes)
    for (const Nearness nearness : kNearnesses) {
      auto& line = lines.emplace_back();
      line = {std::string(to_string(axis)), std::string(to_string(nearness))};
      for (std::size_t m = 0; m < settings.methods.size(); ++m) {
        const auto first = summary.first_failure(axis, nearness, Test::Contact, m);
        line.push_back(first ? levels(axis)[*first].name : "-");
      }
    }
  return "The first level at which contact was wrong about a polygon (-motion: against the motion that was meant)\n" +
         program::aligned(lines);
}

/// Returns how many of the truths of polygons of many vertices `exact` has confirmed.
std::string confirmed(const Summary& summary) {
  if (summary.confirmed + summary.disputed == 0) return "";
  return fmt::format(
      "Of polygons with more than {} vertices, filtered is the truth: exact confirmed {}, {} DISPUTED.\n",
      kMostForExact, program::counted(summary.confirmed, "answer"), summary.disputed);
}

struct Options : program::StudyOptions {
  methods::Selection methods{{"fast", "fast-float", "fast-long-double", "thesis", "thesis-signed", "filtered"}};
  std::vector<std::string> axes{"all"};
};

// Throws program::UsageError, which names what is unknown.
Axis find_axis(const std::string& name) {
  std::string known;
  for (const Axis axis : all_axes()) {
    if (to_string(axis) == name) return axis;
    known.append(known.empty() ? "" : ", ").append(to_string(axis));
  }
  throw program::UsageError("--axes", "there is no axis \"" + name + "\"; there are " + known + ", or all");
}

/// In the order of all_axes(), each once.
std::vector<Axis> select_axes(const std::vector<std::string>& names) {
  if (names == std::vector<std::string>{"all"}) return all_axes();
  std::vector<Axis> selected;
  for (const std::string& name : names) selected.push_back(find_axis(name));
  std::sort(selected.begin(), selected.end());
  selected.erase(std::unique(selected.begin(), selected.end()), selected.end());
  return selected;
}

/// Returns the names of the selected axes, joined by commas.
std::string selected_axes(const std::vector<std::string>& names) {
  std::vector<std::string> words;
  for (const Axis axis : select_axes(names)) words.emplace_back(to_string(axis));
  return program::joined(words);
}

// Raised when a block of a seed changes, or the form of what is kept. Blocks are numbered through all axes.
constexpr int kVersion = 7;

int run_stability(program::StudyRun& run, const Options& options) {
  const Settings settings{options.methods.methods(), select_axes(options.axes), options.samples, options.seed,
                          options.threads};
  const Summary summary = run.phase("samples", "part.json", block_count(settings), Summary(),
                                    [&](const auto& control, Summary& sum) { run_study(settings, control, sum); });
  const std::uint64_t triangles = 10 * settings.samples, done = summary.blocks / settings.axes.size();
  const Onset onset =
      run.phase("onset", "onset-part.json", triangles, Onset(settings.methods), [&](const auto& control, Onset& sum) {
        find_onset(settings.methods, triangles, settings.seed, settings.threads, control, sum);
      });
  if (run.is_part()) return run.finish({.done = done, .missing = summary.missing});
  write_failures(run.folder(), settings, summary);
  write_errors(run.folder(), settings, summary);
  write_worst(run.folder(), summary);
  write_onset(run.folder(), onset);
  return run.finish(
      {.done = done,
       .missing = summary.missing,
       .text = first_failures(settings, summary) + confirmed(summary) + "\n" + text(onset) +
               fmt::format("\n{} samples of each axis; {} polygons were not found.\n", done, summary.missing)});
}

}  // namespace
}  // namespace touchstone::stability

namespace touchstone::commands {

program::Command stability_command() {
  program::Command command("stability", "Measure where methods fail as polygons get worse");
  auto options = std::make_shared<stability::Options>();
  options->samples = 400;
  options->output = "results/stability";
  methods::declare_compared_methods(command, options->methods);
  command.names("--axes", options->axes, "Axes, the properties that get worse, separated by commas, or all")
      .changes_results([options] { return stability::selected_axes(options->axes); });
  program::declare_study(command, *options, "--samples", "Polygons at each level of each axis; fewer at slow levels");
  command.writes({stability::failures_table().description(), stability::first_failure_table().description(),
                  stability::errors_table().description(), stability::onset_description()});
  command.help().examples.emplace_back("stability --methods fast,filtered --axes aspect,origin --samples 20");
  command.runs(program::study_runner(command, stability::kVersion, options, stability::run_stability));
  return command;
}

}  // namespace touchstone::commands
