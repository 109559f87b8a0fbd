// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "experiments/run/output.h"
#include "experiments/run/statistics/shares.h"
#include "experiments/run/table.h"
#include "experiments/studies/stability/summary.h"

namespace touchstone::stability {
namespace {

using run::path;

/// Returns the columns `axis`, `level` and `value` of a row with an axis, or none for all axes, and a level.
template <class Row>
std::vector<run::Column<Row>> level_columns() {
  const auto level = [](const Row& row) { return row.axis ? &levels(*row.axis)[row.level] : nullptr; };
  return {{"axis", "the property that gets worse, or `all`",
           [](const Row& row) { return row.axis ? to_string(*row.axis) : std::string_view("all"); }},
          {"level", "how bad it is, as tables name it",
           [level](const Row& row) { return level(row) ? std::optional(level(row)->name) : std::nullopt; }},
          {"value", "the same as a number",
           [level](const Row& row) { return level(row) ? std::optional(level(row)->value) : std::nullopt; }, "{:.6g}"}};
}

struct FailureRow {
  std::optional<Axis> axis;
  std::size_t level;
  Nearness nearness;
  Test test;
  std::string_view method;
  const SampledFailures* failures;
  run::Rate rate;
};

const run::Table<FailureRow>& failures_table() {
  using cases::Failures;
  const auto of_samples = [](auto number) {
    return path(&FailureRow::failures, path(&SampledFailures::samples, number));
  };
  const auto of_answers = [](auto number) {
    return path(&FailureRow::failures, path(&SampledFailures::answers, number));
  };
  static const run::Table<FailureRow> table(
      "failures.csv", "an axis, level, nearness, test and method",
      run::all_columns<FailureRow>(
          {level_columns<FailureRow>(),
           {{"nearness", "how close the ball's radius is to the exact distance", &FailureRow::nearness},
            {"test", "the decision that is compared", &FailureRow::test},
            {"method", "the method", &FailureRow::method},
            {"failed_samples", "polygons with a wrong answer", of_samples(&Failures::wrong)},
            {"samples", "polygons", of_samples(&Failures::trials)}},
           run::rate_columns<FailureRow>("failed samples", &FailureRow::rate),
           {{"wrong_answers", "wrong answers", of_answers(&Failures::wrong)},
            {"answers", "answers", of_answers(&Failures::trials)}}}));
  return table;
}

/// The last level before the first failure.
struct LevelBefore {
  std::string_view level;
  std::uint64_t samples;
  double upper;  ///< the upper limit of the rate of failures after none was seen
};

struct FirstFailureRow {
  Axis axis;
  Nearness nearness;
  Test test;
  std::string_view method;
  std::optional<std::string_view> first;
  std::optional<LevelBefore> before;
  cases::Failures all;  ///< samples of all levels
  run::Rate rate;
};

/// Returns the function that finds a member of an optional member, or nothing.
template <class Row, class Part, class Value>
auto optional_path(std::optional<Part> Row::*part, Value Part::*value) {
  return [=](const Row& row) { return row.*part ? std::optional((*(row.*part)).*value) : std::nullopt; };
}

const run::Table<FirstFailureRow>& first_failure_table() {
  using Row = FirstFailureRow;
  static const run::Table<Row> table(
      "first-failure.csv", "an axis, nearness, test and method",
      run::all_columns<Row>(
          {{{"axis", "the property that gets worse", &Row::axis},
            {"nearness", "how close the ball's radius is to the exact distance", &Row::nearness},
            {"test", "the decision that is compared", &Row::test},
            {"method", "the method", &Row::method},
            {"first_failure", "the first level with a failure", &Row::first},
            {"level_before", "the level before the first failure; the last one if there was none",
             optional_path(&Row::before, &LevelBefore::level)},
            {"samples_before", "samples there", optional_path(&Row::before, &LevelBefore::samples)},
            {"upper_before", "the upper limit of their rate of failures",
             optional_path(&Row::before, &LevelBefore::upper), "{:.6g}"},
            {"failed_samples", "failed samples of all levels", path(&Row::all, &cases::Failures::wrong)},
            {"samples", "samples of all levels", path(&Row::all, &cases::Failures::trials)}},
           run::rate_columns<Row>("failed samples of all levels", &Row::rate)}));
  return table;
}

/// Returns the columns of a distribution's median, 99 % quantile and maximum.
template <class Row, class Value>
std::vector<run::Column<Row>> quantile_columns(const std::array<std::string, 3>& names, const std::string& what,
                                               const Value& value) {
  constexpr const char* kFormat = "{:.4g}";
  const auto quantile = [value](double share) {
    return [value, share](const Row& row) { return value(row).quantile(share); };
  };
  return {{names[0], "the median of " + what, quantile(0.5), kFormat},
          {names[1], "the 99 % quantile", quantile(0.99), kFormat},
          {names[2], "the maximum", [value](const Row& row) { return value(row).largest(); }, kFormat}};
}

struct ErrorRow {
  std::optional<Axis> axis;
  std::size_t level;
  Quantity quantity;
  std::string_view method;
  const statistics::Distribution* errors;
};

const run::Table<ErrorRow>& errors_table() {
  static const run::Table<ErrorRow> table(
      "errors.csv", "an axis, level, quantity and method",
      run::all_columns<ErrorRow>({level_columns<ErrorRow>(),
                                  {{"quantity", "distance or point", &ErrorRow::quantity},
                                   {"method", "the method", &ErrorRow::method},
                                   {"numbers", "numbers", path(&ErrorRow::errors, &statistics::Distribution::count)},
                                   {"not_finite", "numbers that are not finite",
                                    path(&ErrorRow::errors, &statistics::Distribution::infinite)}},
                                  quantile_columns<ErrorRow>(
                                      {"relative_median", "relative_99", "relative_max"}, "the relative error",
                                      [](const ErrorRow& row) -> const auto& { return *row.errors; })}));
  return table;
}

struct BoundRow {
  const BoundedQuantity* about;
  std::optional<Axis> axis;
  std::size_t level;
  const BoundSummary* bound;
  run::Rate rate;
};

const run::Table<BoundRow>& tightness_table() {
  static const run::Table<BoundRow> table(
      "tightness.csv", "a bounded quantity, axis (or `all`) and level",
      run::all_columns<BoundRow>(
          {{{"stage", "the stage whose bound it is", path(&BoundRow::about, &BoundedQuantity::stage)},
            {"quantity", "the quantity", path(&BoundRow::about, &BoundedQuantity::name)}},
           level_columns<BoundRow>(),
           {{"observations", "observed errors", [](const BoundRow& row) { return row.bound->tightness.count(); }},
            {"exceeded", "errors beyond their bound", path(&BoundRow::bound, &BoundSummary::exceeded)},
            {"exceeded_polygons", "polygons with such an error", path(&BoundRow::bound, &BoundSummary::failed)},
            {"polygons", "polygons", path(&BoundRow::bound, &BoundSummary::polygons)}},
           run::rate_columns<BoundRow>("such polygons", &BoundRow::rate),
           quantile_columns<BoundRow>({"median", "quantile_99", "max"}, "|computed - exact| / bound",
                                      path(&BoundRow::bound, &BoundSummary::tightness))}));
  return table;
}

struct ConditionRow {
  const BoundedQuantity* about;
  Axis axis;
  const ConditionPoint* point;
};

const run::Table<ConditionRow>& conditions_table() {
  using Row = ConditionRow;
  static const run::Table<Row> table(
      "conditions.csv", "one observation, from the first samples of each level",
      {{"stage", "the stage whose bound it is", path(&Row::about, &BoundedQuantity::stage)},
       {"quantity", "the quantity", path(&Row::about, &BoundedQuantity::name)},
       {"constant", "the constant of its bound", path(&Row::about, &BoundedQuantity::constant), "{:.6g}"},
       {"axis", "the property that gets worse", &Row::axis},
       {"level", "how bad it is", [](const Row& row) { return levels(row.axis)[row.point->level].name; }},
       {"condition", "the condition of the quantity", path(&Row::point, &ConditionPoint::condition), "{:.3e}"},
       {"relative_error", "its relative error", path(&Row::point, &ConditionPoint::relative_error), "{:.3e}"}});
  return table;
}

/// Returns the level before the first one with a failure, or the last level if there is none.
std::optional<LevelBefore> before_first(const Settings& settings, const Summary& summary, const Summary::Cell& cell) {
  const auto [axis, nearness, test, method, unused] = cell;
  const auto first = summary.first_level(settings, axis, nearness, test, method, 0);
  std::size_t level = first.value_or(levels(settings.axes[axis]).size());
  while (level-- > 0)
    if (const SampledFailures* failures = summary.at(axis, nearness, test, method, level))
      return LevelBefore{levels(settings.axes[axis])[level].name, failures->samples.trials,
                         statistics::clopper_pearson(0, failures->samples.trials).upper};
  return std::nullopt;
}

}  // namespace

void write_failures(const std::filesystem::path& folder, const Settings& settings, const Summary& summary) {
  std::vector<FailureRow> rows;
  std::vector<FirstFailureRow> firsts;
  for (std::size_t a = 0; a < settings.axes.size(); ++a)
    for (const Nearness nearness : kNearnesses)
      for (const Test test : kCountedTests)
        for (std::size_t m = 0; m < settings.methods.size(); ++m) {
          const Axis axis = settings.axes[a];
          const std::string_view name = settings.methods[m]->name();
          cases::Failures all;
          for (std::size_t level = 0; level < levels(axis).size(); ++level) {
            const SampledFailures* failures = summary.at(a, nearness, test, m, level);
            if (failures == nullptr) continue;
            run::add(all, failures->samples);
            rows.push_back({axis, level, nearness, test, name, failures, failures->samples.rate()});
          }
          if (all.trials == 0) continue;
          const auto first = summary.first_level(settings, a, nearness, test, m, 0);
          firsts.push_back({axis, nearness, test, name,
                            first ? std::optional<std::string_view>(levels(axis)[*first].name) : std::nullopt,
                            before_first(settings, summary, {a, nearness, test, m, 0}), all, all.rate()});
        }
  failures_table().write(folder, rows);
  first_failure_table().write(folder, firsts);
}

void write_errors(const std::filesystem::path& folder, const Settings& settings, const Summary& summary) {
  std::vector<ErrorRow> rows;
  for (const auto& [cell, errors] : summary.errors) {
    const auto& [axis, quantity, method, level] = cell;
    rows.push_back({settings.axes[axis], level, quantity, settings.methods[method]->name(), &errors});
  }
  errors_table().write(folder, rows);
}

void write_bounds(const std::filesystem::path& folder, const Settings& settings, const Summary& summary) {
  std::vector<BoundRow> rows;
  const auto add = [&](std::size_t quantity, std::optional<Axis> axis, std::size_t level, const BoundSummary& bound) {
    rows.push_back({&bounded_quantities()[quantity], axis, level, &bound, run::rate(bound.failed, bound.polygons)});
  };
  for (const auto& [quantity, bound] : summary.all_bounds) add(quantity, std::nullopt, 0, bound);
  for (const auto& [cell, bound] : summary.bounds) {
    const auto& [quantity, axis, level] = cell;
    add(quantity, settings.axes[axis], level, bound);
  }
  tightness_table().write(folder, rows);

  std::vector<ConditionRow> points;
  for (const auto& [block, list] : summary.points)
    for (const ConditionPoint& point : list)
      points.push_back({&bounded_quantities()[point.quantity], settings.axes[block % settings.axes.size()], &point});
  conditions_table().write(folder, points);
}

void write_worst(const std::filesystem::path& folder, const Summary& summary) {
  std::vector<const WorstCase*> cases;
  for (const auto& methods : summary.worst)
    for (const auto& worst : methods)
      if (worst) cases.push_back(&*worst);
  std::ranges::stable_sort(cases, [](const WorstCase* a, const WorstCase* b) {
    return a->rank != b->rank ? a->rank > b->rank : a->error > b->error;
  });
  std::string text;
  for (const WorstCase* worst : cases) text += worst->line;
  run::write_file(folder / "worst.jsonl", text);
}

std::vector<run::TableDescription> tables() {
  return {failures_table().description(), first_failure_table().description(), errors_table().description(),
          tightness_table().description(), conditions_table().description()};
}

}  // namespace touchstone::stability
