// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "experiments/cases/key.h"
#include "experiments/cases/verdict.h"
#include "experiments/methods/registry.h"
#include "experiments/program/output.h"
#include "experiments/program/statistics/shares.h"
#include "experiments/studies/tradeoff/front.h"
#include "robust/exact/exact.h"

namespace touchstone::tradeoff {
namespace {

using cases::all_strata;
using workloads::Placement;

/// Calls line(family or nothing, its name, placement) for each of the selected families, then for all together.
template <class Line>
void for_each_place(const Settings& settings, const Line& line) {
  for (const auto family : settings.families)
    for (const Placement placement : kPlacements) line(std::optional(family), to_string(family), placement);
  for (const Placement placement : kPlacements) line(std::nullopt, "all", placement);
}

std::string_view name(const Settings& settings, std::size_t method) { return settings.methods[method]->name(); }

constexpr const char* kTestMeaning = "contact, or foot where the centre moves";

/// Returns the columns of a row's member `count`; `answers`: the name of the last one.
template <class Row>
std::vector<program::Column<Row>> count_columns(const char* answers) {
  return {{"wrong", "wrong answers about the polygon as given, or by the contract if the method lifts vertices",
           program::path(&Row::count, &Answers::wrong)},
          {"contract", "answers wrong or undecided by the contract, which lifts vertices",
           program::path(&Row::count, &Answers::contract)},
          {"lift", "of these, answers right about the polygon as given", program::path(&Row::count, &Answers::lift)},
          {"overflowed", "wrong answers for which the method's distance or point is not finite",
           program::path(&Row::count, &Answers::overflowed)},
          {"unsure", "undecided answers", program::path(&Row::count, &Answers::unsure)},
          {answers, "answers", program::path(&Row::count, &Answers::trials)}};
}

using OffsetRow = cases::OffsetRow<Answers>;

const program::Table<OffsetRow>& errors_table() {
  static const program::Table<OffsetRow> table(
      "errors.csv", "a family, placement, threshold, method and offset",
      cases::offset_columns<OffsetRow>(kTestMeaning, count_columns<OffsetRow>("trials"), "wrong answers"));
  return table;
}

struct BandRow : cases::Subject {
  std::uint64_t samples;
  Answers count;  ///< near the threshold
  cases::Band band;
  program::Rate rate;
};

const program::Table<BandRow>& bands_table() {
  static const program::Table<BandRow> table(
      "bands.csv", "a family, placement, threshold and method, within 1 u x size of the threshold",
      program::all_columns<BandRow>({cases::subject_columns<BandRow>(kTestMeaning),
                                     {{"samples", "samples, which are independent", &BandRow::samples}},
                                     count_columns<BandRow>("answers"),
                                     program::rate_columns<BandRow>("wrong answers", &BandRow::rate),
                                     cases::band_columns<BandRow>("the lowest offset with a wrong answer")}));
  return table;
}

/// A family, or all, in a placement.
struct Where {
  std::string_view family;
  Placement placement;
};

template <class Row>
std::vector<program::Column<Row>> where_columns() {
  return {{"family", "the family of polygons, or `all`", program::path(&Row::where, &Where::family)},
          {"placement", "exactly planar, or rotated and rounded", program::path(&Row::where, &Where::placement)},
          {"method", "the method", &Row::method}};
}

struct PointRow {
  Where where;
  std::string_view method;
  Quantity quantity;
  UlpErrors ulps;

  [[nodiscard]] double quantile(double share) const { return ulps.quantile_of_finite(share); }
};

const program::Table<PointRow>& points_table() {
  constexpr const char* kFormat = "{:.6g}";
  static const program::Table<PointRow> table(
      "points.csv", "a family, placement, method and quantity, with its errors in units in the last place",
      program::all_columns<PointRow>(
          {where_columns<PointRow>(),
           {{"quantity", "distance or point", &PointRow::quantity},
            {"asked", "answers", [](const PointRow& row) { return row.ulps.asked; }},
            {"known", "answers that give the quantity", [](const PointRow& row) { return row.ulps.known.count(); }},
            {"not_finite", "those that are not finite", [](const PointRow& row) { return row.ulps.known.infinite(); }},
            {"correctly_rounded", "those without error", [](const PointRow& row) { return row.ulps.known.zeros(); }},
            {"median", "the median error of finite ones", [](const PointRow& row) { return row.quantile(0.5); },
             kFormat},
            {"q99", "their 99 % quantile", [](const PointRow& row) { return row.quantile(0.99); }, kFormat},
            {"worst", "their largest error", [](const PointRow& row) { return row.quantile(1); }, kFormat}}}));
  return table;
}

constexpr const char* kThrough =
    "call, or pipe: a program answers, so that times include JSON, the pipe and two changes of process";

/// How a method is asked.
std::string_view through(std::string_view method) {
  return methods::find_method(method)->through_pipe() ? "pipe" : "call";
}

struct TimingRow {
  const Timing* timing;
  const timing::Measured* measured;
  timing::Quartiles nanoseconds;
};

const program::Table<TimingRow>& timings_table() {
  constexpr const char* kFormat = "{:.1f}";
  static const program::Table<TimingRow> table(
      "timings.csv", "a list of questions and a method",
      {{"family", "the family of polygons", [](const TimingRow& row) { return row.timing->group.family; }},
       {"placement", "exactly planar, or rotated and rounded",
        [](const TimingRow& row) { return row.timing->group.placement; }},
       {"balls", "where the balls are", program::path(&TimingRow::timing, &Timing::balls)},
       {"question", "contact, or the whole answer", [](const TimingRow& row) { return to_string(row.timing->kind); }},
       {"method", "the method", program::path(&TimingRow::measured, &timing::Measured::name)},
       {"asked", "questions", program::path(&TimingRow::measured, &timing::Measured::queries)},
       {"repetitions", "turns of the method", [](const TimingRow& row) { return row.measured->nanoseconds.size(); }},
       {"lower_quartile_ns", "a question, over the turns",
        program::path(&TimingRow::nanoseconds, &timing::Quartiles::lower), kFormat},
       {"median_ns", "the same, median", program::path(&TimingRow::nanoseconds, &timing::Quartiles::median), kFormat},
       {"upper_quartile_ns", "the same, upper quartile",
        program::path(&TimingRow::nanoseconds, &timing::Quartiles::upper), kFormat},
       {"through", kThrough, [](const TimingRow& row) { return through(row.measured->name); }}});
  return table;
}

struct FrontRow {
  Measure measure;
  Where where;
  std::string_view method;
  ParetoEntry entry;
};

const program::Table<FrontRow>& front_table() {
  constexpr const char* kTime = "{:.1f}";
  constexpr const char* kError = "{:.6g}";
  static const program::Table<FrontRow> table(
      "front.csv", "a measure of error, family, placement and method",
      program::all_columns<FrontRow>(
          {{{"measure", "the measure of error", &FrontRow::measure}},
           where_columns<FrontRow>(),
           {{"nanoseconds", "a question, median", [](const FrontRow& row) { return row.entry.nanoseconds.median; },
             kTime},
            {"lower_quartile_ns", "a question", [](const FrontRow& row) { return row.entry.nanoseconds.lower; }, kTime},
            {"upper_quartile_ns", "a question", [](const FrontRow& row) { return row.entry.nanoseconds.upper; }, kTime},
            {"error",
             "the share of answers, the largest offset in u x size, or the 99 % quantile of units in the last place",
             program::path(&FrontRow::entry, &ParetoEntry::error), kError},
            {"lower", "the lower limit of a share; the median of units",
             program::path(&FrontRow::entry, &ParetoEntry::lower), kError},
            {"upper", "the upper limit of a share; the worst of units",
             program::path(&FrontRow::entry, &ParetoEntry::upper), kError},
            {"finite_error", "the error of finite answers", program::path(&FrontRow::entry, &ParetoEntry::finite_error),
             kError},
            {"not_finite", "the share of answers that are not finite, or wrong for that reason",
             program::path(&FrontRow::entry, &ParetoEntry::not_finite), kError},
            {"samples", "polygons behind the error", program::path(&FrontRow::entry, &ParetoEntry::samples)},
            {"front", "on: nothing is better; within-noise; off: another method is better",
             program::path(&FrontRow::entry, &ParetoEntry::front)},
            {"through", kThrough, [](const FrontRow& row) { return through(row.method); }}}}));
  return table;
}

/// Draws the sample again and states what is expected of it.
std::string worst_case(const Settings& settings, std::size_t method, Quantity quantity, const Worst& worst) {
  const auto crossing =
      cases::draw_crossing({worst.stratum, {}, settings.seed, worst.n}, *methods::find_method("exact"));
  const Ball& ball = crossing->balls[crossing->middle()];
  const auto truth = cases::PartialAnswer::of(exact::answer(ball, crossing->polygon), "");
  const auto& [family, placement, threshold] = all_strata()[worst.stratum];
  const std::string id =
      fmt::format("worst-{}-{}-{}-{}-{}-s{}-n{}", to_string(quantity), name(settings, method), to_string(family),
                  to_string(placement), to_string(threshold), settings.seed, worst.n);
  const std::vector<std::string> tags{
      std::string(name(settings, method)), std::string(to_string(quantity)),
      std::isfinite(worst.ulps) ? fmt::format("{:.6g} ulps", worst.ulps) : "not finite"};
  return cases::case_line(
      id, cases::Shapes{ball, crossing->polygon}, tags,
      cases::only(truth, {quantity == Quantity::Distance ? cases::key_of(&cases::PartialAnswer::distance)
                                                         : cases::key_of(&cases::PartialAnswer::point)}));
}

std::vector<PointRow> point_rows(const Settings& settings, const Errors& errors) {
  std::vector<PointRow> rows;
  for_each_place(settings, [&](auto family, std::string_view family_name, Placement placement) {
    const auto strata = strata_of(family, placement, true);
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const MethodErrors sum = errors.sum(strata, m);
      for (std::size_t q = 0; q < kQuantities.size(); ++q)
        if (sum.ulps[q].known.count() > sum.ulps[q].known.infinite())
          rows.push_back({{family_name, placement}, name(settings, m), kQuantities[q], sum.ulps[q]});
    }
  });
  return rows;
}

std::vector<FrontRow> front_rows(const Settings& settings, const Errors& errors, const std::vector<Timing>& timings) {
  std::vector<FrontRow> rows;
  for (const Measure measure : kMeasures)
    for_each_place(settings, [&](auto family, std::string_view family_name, Placement placement) {
      for (const ParetoEntry& entry : pareto_entries(measure, family, placement, errors, timings))
        rows.push_back({measure, {family_name, placement}, name(settings, entry.method), entry});
    });
  return rows;
}

/// Returns the rows about all families, for the terminal.
template <class Row>
std::string of_all_families(const program::Table<Row>& table, std::vector<Row> rows) {
  std::erase_if(rows, [](const Row& row) { return row.where.family != "all"; });
  return table.aligned(rows) + "\n";
}

/// Returns how much the repetitions of timed lists differ.
std::string noise(const std::vector<Timing>& timings) {
  constexpr double kMuch = 1.5;
  std::size_t cells = 0, noisy = 0;
  for (const Timing& t : timings)
    for (const timing::Measured& m : t.methods) {
      const auto q = timing::quartiles(m.nanoseconds);
      ++cells;
      noisy += q.upper > kMuch * q.lower ? 1 : 0;
    }
  return fmt::format(
      "Noise: in {} of {} lists and methods the upper quartile of the repetitions is more than {} times the lower one.\n",
      noisy, cells, kMuch);
}

}  // namespace

void write_errors(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  std::vector<OffsetRow> offsets;
  std::vector<BandRow> bands;
  const auto groups = cases::stratum_groups(settings);
  for (const auto& group : groups)
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const cases::Subject subject{&group, cases::test_at(group.threshold), name(settings, m)};
      const MethodErrors sum = errors.sum(group.strata, m);
      for (std::size_t i = 0; i < sum.offsets.size(); ++i)
        if (const Answers& at = sum.offsets[i]; at.trials > 0)
          offsets.push_back({subject, cases::all_offsets()[i], at, at.rate()});
      const Answers near = sum.near_threshold();
      if (near.trials == 0) continue;
      // Samples are independent, answers are not.
      const auto limits = statistics::bounded_mean(near.share(), sum.samples);
      bands.push_back({subject,
                       sum.samples,
                       near,
                       cases::band_of(sum.offsets, &Answers::wrong),
                       {near.share(), limits.lower, limits.upper}});
    }
  errors_table().write(folder, offsets);
  bands_table().write(folder, bands);
  points_table().write(folder, point_rows(settings, errors));
  std::string worst;
  for (const Placement placement : kPlacements)
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const MethodErrors sum = errors.sum(strata_of(std::nullopt, placement, true), m);
      for (std::size_t q = 0; q < kQuantities.size(); ++q)
        if (sum.worst[q].ulps > 0) worst += worst_case(settings, m, kQuantities[q], sum.worst[q]);
    }
  program::write_file(folder / "worst.jsonl", worst);
}

void write_timings(const std::filesystem::path& folder, const std::vector<Timing>& timings) {
  std::vector<TimingRow> rows;
  for (const Timing& timing : timings)
    for (const timing::Measured& m : timing.methods) rows.push_back({&timing, &m, timing::quartiles(m.nanoseconds)});
  timings_table().write(folder, rows);
}

void write_front(const std::filesystem::path& folder, const Settings& settings, const Errors& errors,
                 const std::vector<Timing>& timings) {
  front_table().write(folder, front_rows(settings, errors, timings));
}

std::vector<program::TableDescription> tables() {
  return {errors_table().description(), bands_table().description(), points_table().description(),
          timings_table().description(), front_table().description()};
}

std::string table(const Settings& settings, const Errors& errors, const std::vector<Timing>& timings) {
  return "\n" + of_all_families(front_table(), front_rows(settings, errors, timings)) +
         of_all_families(points_table(), point_rows(settings, errors)) +
         (timings.empty() ? "Nothing was timed.\n" : noise(timings)) +
         fmt::format(
             "Slow methods are asked about one sample in {}. `touchstone columns tradeoff` explains the columns.\n",
             kSlowStride);
}

}  // namespace touchstone::tradeoff
