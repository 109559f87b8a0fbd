// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/tradeoff/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "experiments/cases/output_lines.h"
#include "experiments/cases/stratum_group.h"
#include "experiments/methods/registry.h"
#include "experiments/run/statistics/bounded_mean.h"
#include "experiments/run/statistics/percent.h"
#include "experiments/run/table.h"
#include "experiments/run/write_file.h"
#include "experiments/studies/tradeoff/band.h"
#include "experiments/studies/tradeoff/front.h"
#include "robust/exact/exact.h"

namespace touchstone::tradeoff {
namespace {

using cases::all_offsets;
using cases::all_strata;
using workloads::Placement;

constexpr std::array kPlacements{Placement::LatticeFrame, Placement::Rotated};

/// Calls line(family or nothing, its name, placement) for each of the selected families, then for all together.
template <class Line>
void for_each_place(const Settings& settings, const Line& line) {
  for (const auto family : settings.families)
    for (const Placement placement : kPlacements) line(std::optional(family), to_string(family), placement);
  for (const Placement placement : kPlacements) line(std::nullopt, "all", placement);
}

std::string_view name(const Settings& settings, std::size_t method) { return settings.methods[method]->name(); }

struct OffsetRow {
  const cases::StratumGroup* group;
  std::string_view method;
  std::int64_t offset;
  Tally tally;
  run::Rate rate;
};

struct BandRow {
  const cases::StratumGroup* group;
  std::string_view method;
  std::uint64_t samples;
  Tally near;
  Band band;
  run::Rate rate;
};

/// Returns the columns with which the rows of both tables begin.
template <class Row>
std::vector<run::Column<Row>> subject_columns() {
  return run::all_columns<Row>({cases::stratum_columns(&Row::group),
                                {{"test", "contact, or foot where the centre moves",
                                  [](const Row& row) { return test_at(row.group->threshold); }},
                                 {"method", "the method", &Row::method}}});
}

const run::Table<OffsetRow>& errors_table() {
  static const run::Table<OffsetRow> table(
      "errors.csv", "a family, placement, threshold, method and offset",
      run::all_columns<OffsetRow>(
          {subject_columns<OffsetRow>(),
           {{"offset", "the distance of the ball from the threshold, in doubles", &OffsetRow::offset},
            {"wrong", "wrong answers", run::path(&OffsetRow::tally, &Tally::wrong)},
            {"overflowed", "wrong answers for which the method's distance or point is not finite",
             run::path(&OffsetRow::tally, &Tally::overflowed)},
            {"unsure", "undecided answers", run::path(&OffsetRow::tally, &Tally::unsure)},
            {"trials", "answers", run::path(&OffsetRow::tally, &Tally::trials)}},
           run::rate_columns<OffsetRow>("wrong answers", &OffsetRow::rate)}));
  return table;
}

const run::Table<BandRow>& bands_table() {
  static const run::Table<BandRow> table(
      "bands.csv", "a family, placement, threshold and method, within 8 doubles of the threshold",
      run::all_columns<BandRow>(
          {subject_columns<BandRow>(),
           {{"samples", "samples, which are independent", &BandRow::samples},
            {"wrong", "wrong answers", run::path(&BandRow::near, &Tally::wrong)},
            {"overflowed", "wrong answers for which the method's distance or point is not finite",
             run::path(&BandRow::near, &Tally::overflowed)},
            {"unsure", "undecided answers", run::path(&BandRow::near, &Tally::unsure)},
            {"answers", "answers", run::path(&BandRow::near, &Tally::trials)}},
           run::rate_columns<BandRow>("wrong answers", &BandRow::rate),
           {{"lowest_offset", "the lowest offset with a wrong answer", run::path(&BandRow::band, &Band::lowest)},
            {"highest_offset", "the highest one", run::path(&BandRow::band, &Band::highest)}}}));
  return table;
}

/// A family, or all, in a placement.
struct Where {
  std::string_view family;
  Placement placement;
};

template <class Row>
std::vector<run::Column<Row>> where_columns() {
  return {{"family", "the family of polygons, or `all`", run::path(&Row::where, &Where::family)},
          {"placement", "on the lattice, or rotated", run::path(&Row::where, &Where::placement)},
          {"method", "the method", &Row::method}};
}

struct PointRow {
  Where where;
  std::string_view method;
  Quantity quantity;
  UlpErrors ulps;
  Worst worst;

  [[nodiscard]] double quantile(double share) const { return ulps.quantile_of_finite(share); }
  /// Returns the stratum of the worst sample, if there is one.
  [[nodiscard]] const cases::Stratum* stratum() const {
    return worst.ulps == 0 ? nullptr : &all_strata()[worst.stratum];
  }
};

const run::Table<PointRow>& points_table() {
  constexpr const char* kFormat = "{:.6g}";
  static const run::Table<PointRow> table(
      "points.csv", "a family, placement, method and quantity, with its errors in units in the last place",
      run::all_columns<PointRow>(
          {where_columns<PointRow>(),
           {{"quantity", "distance or point", &PointRow::quantity},
            {"asked", "answers", [](const PointRow& row) { return row.ulps.asked; }},
            {"known", "answers that give the quantity", [](const PointRow& row) { return row.ulps.known.count(); }},
            {"not_finite", "those that are not finite", [](const PointRow& row) { return row.ulps.known.infinite(); }},
            {"correctly_rounded", "those without error", [](const PointRow& row) { return row.ulps.known.zeros(); }},
            {"median", "the median error of finite ones", [](const PointRow& row) { return row.quantile(0.5); },
             kFormat},
            {"q99", "their 99 % quantile", [](const PointRow& row) { return row.quantile(0.99); }, kFormat},
            {"worst", "their largest error", [](const PointRow& row) { return row.quantile(1); }, kFormat},
            {"worst_family", "the family of the worst sample: one that is not finite, if there is any",
             [](const PointRow& row) { return row.stratum() ? std::optional(row.stratum()->family) : std::nullopt; }},
            {"worst_threshold", "its threshold",
             [](const PointRow& row) {
               return row.stratum() ? std::optional(row.stratum()->threshold) : std::nullopt;
             }},
            {"worst_sample", "its number",
             [](const PointRow& row) { return row.stratum() ? std::optional(row.worst.n) : std::nullopt; }}}}));
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

const run::Table<TimingRow>& timings_table() {
  constexpr const char* kFormat = "{:.1f}";
  static const run::Table<TimingRow> table(
      "timings.csv", "a list of questions and a method",
      {{"family", "the family of polygons", [](const TimingRow& row) { return row.timing->group.family; }},
       {"placement", "on the lattice, or rotated", [](const TimingRow& row) { return row.timing->group.placement; }},
       {"balls", "where the balls are", run::path(&TimingRow::timing, &Timing::balls)},
       {"question", "contact, or the whole answer", [](const TimingRow& row) { return to_string(row.timing->kind); }},
       {"method", "the method", run::path(&TimingRow::measured, &timing::Measured::name)},
       {"asked", "questions", run::path(&TimingRow::measured, &timing::Measured::queries)},
       {"repetitions", "turns of the method", [](const TimingRow& row) { return row.measured->nanoseconds.size(); }},
       {"lower_quartile_ns", "a question, over the turns",
        run::path(&TimingRow::nanoseconds, &timing::Quartiles::lower), kFormat},
       {"median_ns", "the same, median", run::path(&TimingRow::nanoseconds, &timing::Quartiles::median), kFormat},
       {"upper_quartile_ns", "the same, upper quartile", run::path(&TimingRow::nanoseconds, &timing::Quartiles::upper),
        kFormat},
       {"through", kThrough, [](const TimingRow& row) { return through(row.measured->name); }}});
  return table;
}

struct FrontRow {
  Measure measure;
  Where where;
  std::string_view method;
  ParetoEntry entry;
};

const run::Table<FrontRow>& front_table() {
  constexpr const char* kTime = "{:.1f}";
  constexpr const char* kError = "{:.6g}";
  static const run::Table<FrontRow> table(
      "front.csv", "a measure of error, family, placement and method",
      run::all_columns<FrontRow>(
          {{{"measure", "the measure of error", &FrontRow::measure}},
           where_columns<FrontRow>(),
           {{"nanoseconds", "a question, median", [](const FrontRow& row) { return row.entry.nanoseconds.median; },
             kTime},
            {"lower_quartile_ns", "a question", [](const FrontRow& row) { return row.entry.nanoseconds.lower; }, kTime},
            {"upper_quartile_ns", "a question", [](const FrontRow& row) { return row.entry.nanoseconds.upper; }, kTime},
            {"error", "the share of answers, or the 99 % quantile of units in the last place",
             run::path(&FrontRow::entry, &ParetoEntry::error), kError},
            {"lower", "the lower limit of a share; the median of units",
             run::path(&FrontRow::entry, &ParetoEntry::lower), kError},
            {"upper", "the upper limit of a share; the worst of units",
             run::path(&FrontRow::entry, &ParetoEntry::upper), kError},
            {"finite_error", "the error of finite answers", run::path(&FrontRow::entry, &ParetoEntry::finite_error),
             kError},
            {"not_finite", "the share of answers that are not finite, or wrong for that reason",
             run::path(&FrontRow::entry, &ParetoEntry::not_finite), kError},
            {"samples", "polygons behind the error", run::path(&FrontRow::entry, &ParetoEntry::samples)},
            {"front", "on: nothing is better; within-noise; off: another method is better",
             run::path(&FrontRow::entry, &ParetoEntry::front)},
            {"through", kThrough, [](const FrontRow& row) { return through(row.method); }}}}));
  return table;
}

/// Draws the sample again and states what is expected of it.
std::string worst_case(const Settings& settings, std::size_t method, Quantity quantity, const Worst& worst) {
  const auto crossing =
      cases::draw_crossing({worst.stratum, {}, settings.seed, worst.n}, *methods::find_method("exact"));
  const Ball& ball = crossing->balls[crossing->balls.size() / 2];
  const Answer truth = exact::answer(ball, crossing->polygon);
  cases::PartialAnswer expected;
  if (quantity == Quantity::Distance)
    expected.distance = truth.distance;
  else
    expected.point = truth.point;
  const auto& [family, placement, threshold] = all_strata()[worst.stratum];
  const std::string id =
      fmt::format("worst-{}-{}-{}-{}-{}-s{}-n{}", to_string(quantity), name(settings, method), to_string(family),
                  to_string(placement), to_string(threshold), settings.seed, worst.n);
  const std::vector<std::string> tags{
      std::string(name(settings, method)), std::string(to_string(quantity)),
      std::isfinite(worst.ulps) ? fmt::format("{:.6g} ulps", worst.ulps) : "not finite"};
  return cases::case_line(id, ball, crossing->polygon, tags, expected);
}

}  // namespace

void write_errors(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  const auto groups = cases::stratum_groups(settings.families);
  std::vector<OffsetRow> rows;
  for (const auto& group : groups)
    for (std::size_t m = 0; m < settings.methods.size(); ++m)
      for (std::size_t i = 0; i < all_offsets().size(); ++i) {
        Tally tally;
        for (const std::size_t stratum : group.strata) tally += errors.at[stratum][m].offsets[i];
        if (tally.trials > 0)
          rows.push_back({&group, name(settings, m), all_offsets()[i], tally, run::rate(tally.wrong, tally.trials)});
      }
  errors_table().write(folder, rows);
}

void write_bands(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  const auto groups = cases::stratum_groups(settings.families);
  std::vector<BandRow> rows;
  for (const auto& group : groups)
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const MethodErrors sum = errors.sum(group.strata, m);
      const Tally near = sum.near_threshold();
      if (near.trials == 0) continue;
      // Samples are independent, answers are not.
      const double share = statistics::share_of(near.wrong, near.trials);
      const auto limits = statistics::bounded_mean(share, sum.samples);
      rows.push_back({&group, name(settings, m), sum.samples, near, band_of(sum), {share, limits.lower, limits.upper}});
    }
  bands_table().write(folder, rows);
}

void write_points(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  std::vector<PointRow> rows;
  for_each_place(settings, [&](auto family, std::string_view family_name, Placement placement) {
    const auto strata = strata_of(family, placement, true);
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const MethodErrors sum = errors.sum(strata, m);
      for (std::size_t q = 0; q < kQuantities.size(); ++q)
        if (sum.ulps[q].known.count() > sum.ulps[q].known.infinite())
          rows.push_back({{family_name, placement}, name(settings, m), kQuantities[q], sum.ulps[q], sum.worst[q]});
    }
  });
  points_table().write(folder, rows);
}

void write_worst(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  std::string text;
  for (const Placement placement : kPlacements)
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const MethodErrors sum = errors.sum(strata_of(std::nullopt, placement, true), m);
      for (std::size_t q = 0; q < kQuantities.size(); ++q)
        if (sum.worst[q].ulps > 0) text += worst_case(settings, m, kQuantities[q], sum.worst[q]);
    }
  run::write_file(folder / "worst.jsonl", text);
}

void write_timings(const std::filesystem::path& folder, const std::vector<Timing>& timings) {
  std::vector<TimingRow> rows;
  for (const Timing& timing : timings)
    for (const timing::Measured& m : timing.methods) rows.push_back({&timing, &m, timing::quartiles(m.nanoseconds)});
  timings_table().write(folder, rows);
}

void write_front(const std::filesystem::path& folder, const Settings& settings, const Errors& errors,
                 const std::vector<Timing>& timings) {
  std::vector<FrontRow> rows;
  for (const Measure measure : kMeasures)
    for_each_place(settings, [&](auto family, std::string_view family_name, Placement placement) {
      for (const ParetoEntry& entry : pareto_entries(measure, family, placement, errors, timings))
        rows.push_back({measure, {family_name, placement}, name(settings, entry.method), entry});
    });
  front_table().write(folder, rows);
}

std::vector<run::TableDescription> tables() {
  return {errors_table().description(), bands_table().description(), points_table().description(),
          timings_table().description(), front_table().description()};
}

}  // namespace touchstone::tradeoff
