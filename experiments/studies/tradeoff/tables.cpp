// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "experiments/cases/output_lines.h"
#include "experiments/methods/registry.h"
#include "experiments/run/output.h"
#include "experiments/run/statistics/shares.h"
#include "experiments/studies/tradeoff/front.h"
#include "robust/exact/exact.h"

namespace touchstone::tradeoff {
namespace {

using cases::all_strata;
using cases::QueryKind;
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

cases::Subject subject(const Settings& settings, const cases::StratumGroup& group, std::size_t method) {
  return {&group, cases::test_at(group.threshold), name(settings, method)};
}

cases::Band band_of(const MethodErrors& errors) { return cases::band_of(errors.offsets, &Answers::wrong); }

constexpr const char* kTestMeaning = "contact, or foot where the centre moves";

/// Returns the columns of a row's member `count`; `answers`: the name of the last one.
template <class Row>
std::vector<run::Column<Row>> count_columns(const char* answers) {
  return {{"wrong", "wrong answers", run::path(&Row::count, &Answers::wrong)},
          {"overflowed", "wrong answers for which the method's distance or point is not finite",
           run::path(&Row::count, &Answers::overflowed)},
          {"unsure", "undecided answers", run::path(&Row::count, &Answers::unsure)},
          {answers, "answers", run::path(&Row::count, &Answers::trials)}};
}

using OffsetRow = cases::OffsetRow<Answers>;

const run::Table<OffsetRow>& errors_table() {
  static const run::Table<OffsetRow> table(
      "errors.csv", "a family, placement, threshold, method and offset",
      cases::offset_columns<OffsetRow>(kTestMeaning, count_columns<OffsetRow>("trials"), "wrong answers"));
  return table;
}

struct BandRow : cases::Subject {
  std::uint64_t samples;
  Answers count;  ///< near the threshold
  cases::Band band;
  run::Rate rate;
};

const run::Table<BandRow>& bands_table() {
  static const run::Table<BandRow> table(
      "bands.csv", "a family, placement, threshold and method, within 8 doubles of the threshold",
      run::all_columns<BandRow>({cases::subject_columns<BandRow>(kTestMeaning),
                                 {{"samples", "samples, which are independent", &BandRow::samples}},
                                 count_columns<BandRow>("answers"),
                                 run::rate_columns<BandRow>("wrong answers", &BandRow::rate),
                                 cases::band_columns<BandRow>("the lowest offset with a wrong answer")}));
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

  [[nodiscard]] double quantile(double share) const { return ulps.quantile_of_finite(share); }
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
  return cases::case_line(id, cases::Shapes{ball, crossing->polygon}, tags, expected);
}

std::string three_digits(double value) {
  if (!std::isfinite(value)) return "inf";
  if (value == 0 || (value >= 1 && value < 1e5))
    return fmt::format("{:.{}f}", value, value < 10 && value != std::floor(value) ? 1 : 0);
  return fmt::format("{:.2g}", value);
}

std::string percent(double share) {
  return share < 0.0095 ? statistics::percent_to_digits(share, 2) : statistics::percent_to_places(share, 1);
}

/// The mean over all groups of a placement; how many were asked, in the list of the fewest and of the most.
struct Times {
  double nanoseconds = 0;
  std::size_t lists = 0, fewest = 0, most = 0;
};

Times times_of(std::size_t method, Balls balls, QueryKind kind, Placement placement,
               const std::vector<Timing>& timings) {
  Times times;
  for (const Timing& t : timings) {
    if (t.balls != balls || t.kind != kind || t.group.placement != placement) continue;
    const timing::Measured& measured = t.methods[method];
    times.nanoseconds += timing::quartiles(measured.nanoseconds).median;
    times.fewest = times.lists == 0 ? measured.queries : std::min(times.fewest, measured.queries);
    times.most = std::max(times.most, measured.queries);
    ++times.lists;
  }
  if (times.lists > 0) times.nanoseconds /= static_cast<double>(times.lists);
  return times;
}

std::string time_text(const Times& times) { return times.lists == 0 ? "-" : three_digits(times.nanoseconds); }

std::string asked_text(const Times& times) {
  if (times.lists == 0) return "-";
  return times.fewest == times.most ? std::to_string(times.most) : fmt::format("{}..{}", times.fewest, times.most);
}

std::string times_and_shares(const Settings& settings, const Errors& errors, const std::vector<Timing>& timings,
                             Placement placement) {
  const auto row = [](auto... cells) {
    return fmt::format("  {:<22}{:>7}{:>9}{:>8}{:>9}  {:<9}{:>6}  {:<13}{:>7}{:>7}  {}\n", cells...);
  };
  std::string text =
      row("", "contact", "contact", "answer", "answer", "", "wrong", "95 %", "over-", "don't", "wrong at");
  text +=
      row("nanoseconds", "near", "anywhere", "near", "anywhere", "asked", "%", "limits", "flow %", "know %", "offsets");
  for (std::size_t m = 0; m < settings.methods.size(); ++m) {
    const auto strata = strata_of(std::nullopt, placement, true);
    const MethodErrors sum = errors.sum(strata, m);
    const Answers near = sum.near_threshold();
    const auto share = [&](std::uint64_t count) { return statistics::share_of(count, near.trials); };
    const auto cell = [&](const std::string& said) { return near.trials == 0 ? "-" : said; };  // it has no such test
    const auto limits = statistics::bounded_mean(share(near.wrong), errors.polygons(strata, m));
    const auto time = [&](Balls balls, QueryKind kind) { return times_of(m, balls, kind, placement, timings); };
    text +=
        row(settings.methods[m]->name(), time_text(time(Balls::Near, QueryKind::Contact)),
            time_text(time(Balls::Anywhere, QueryKind::Contact)), time_text(time(Balls::Near, QueryKind::Answer)),
            time_text(time(Balls::Anywhere, QueryKind::Answer)), asked_text(time(Balls::Near, QueryKind::Contact)),
            cell(percent(share(near.wrong))), cell(percent(limits.lower) + " to " + percent(limits.upper)),
            cell(percent(share(near.overflowed))), cell(percent(share(near.unsure))), cell(to_string(band_of(sum))));
  }
  return text;
}

std::string units(const Settings& settings, const Errors& errors, Placement placement) {
  const auto row = [](auto... cells) {
    return fmt::format("  {:<22}{:>7}{:>10}{:>8}{:>9}{:>9}{:>9}   {:>8}{:>8}{:>9}{:>9}{:>9}\n", cells...);
  };
  std::string text = row("", "", "distance:", "not", "", "", "", "point:", "not", "", "", "");
  text += row("units in last place", "asked", "known", "finite", "median", "99 %", "worst", "known", "finite", "median",
              "99 %", "worst");
  for (std::size_t m = 0; m < settings.methods.size(); ++m) {
    const MethodErrors sum = errors.sum(strata_of(std::nullopt, placement, true), m);
    const auto& [distance, point] = sum.ulps;
    if (distance.known.count() == 0 && point.known.count() == 0) continue;
    const auto cell = [](const UlpErrors& e, double q) {
      return e.known.count() == e.known.infinite() ? "-" : three_digits(e.quantile_of_finite(q));
    };
    text += row(settings.methods[m]->name(), distance.asked, distance.known.count(), distance.known.infinite(),
                cell(distance, 0.5), cell(distance, 0.99), cell(distance, 1), point.known.count(),
                point.known.infinite(), cell(point, 0.5), cell(point, 0.99), cell(point, 1));
  }
  return text;
}

std::string_view in_words(Measure measure) {
  switch (measure) {
    case Measure::NotRight: return "wrong or don't know, contact";
    case Measure::Distance: return "distance, 99 %";
    case Measure::Point: break;
  }
  return "point, 99 %";
}

/// Who is on the front by each measure, and whom noise may keep from it.
std::string fronts(const Settings& settings, const Errors& errors, const std::vector<Timing>& timings,
                   Placement placement) {
  std::string text;
  for (const Measure measure : kMeasures) {
    const auto list = pareto_entries(measure, std::nullopt, placement, errors, timings);
    const auto names = [&](Front front) {
      std::string joined;
      for (const ParetoEntry& s : list)
        if (s.front == front) joined.append(joined.empty() ? "" : ", ").append(settings.methods[s.method]->name());
      return joined.empty() ? std::string("-") : joined;
    };
    if (list.empty()) continue;
    text += fmt::format("  {:<30}on the front: {}\n  {:<30}within noise: {}\n", in_words(measure), names(Front::On), "",
                        names(Front::WithinNoise));
  }
  return text.empty() ? text : "\n  fronts of time against\n" + text;
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
      "Noise: in {} of {} lists and methods the upper quartile of the repetitions is more than {} "
      "times the lower one.\n"
      "A method is on the front if every method at least as accurate (as observed, on the same "
      "questions) is slower: its\n"
      "lower quartile is above the method's upper one. It is within noise if none is faster in that "
      "sense, but some are\n"
      "not slower.\n",
      noisy, cells, kMuch);
}

std::string legend(const std::vector<Timing>& timings) {
  std::string text = fmt::format(
      "Times: nanoseconds per question about a prepared polygon, through the common interface; means "
      "over the families\n"
      "of medians of the repetitions, in which all methods take turns on one list of distinct balls. "
      "near: the radius\n"
      "is within {} doubles of the distance. asked: the number of questions of the list contact, near; a slow method\n"
      "gets the first ones, as many as fit into {:g} ms. wrong, don't know: answers to contact within "
      "{} doubles of the\n"
      "radius that just touches; limits: Hoeffding, 95 %, for independent polygons. Slow methods were "
      "asked about one\n"
      "sample in {}. overflow: wrong answers in samples for which the method's distance or point is not finite.\n"
      "wrong at offsets: the lowest and the highest tested offset with a wrong answer, in doubles, up to 2^32.\n"
      "Units in the last place: of the exact distance, and of the largest coordinate of the exact point, both\n"
      "correctly rounded, so that 0 is within half a unit of the truth; median, 99 % and worst of the finite errors.\n"
      "Methods that compute neither are left out. No line mixes lattices with rotated polygons; one "
      "lattice radius in\n"
      "four is exactly tangent.\n",
      kNear, 1e3 * kSecondsOfList, kNear, kSlowStride);
  return text + (timings.empty() ? "Nothing was timed.\n" : noise(timings));
}

}  // namespace

void write_errors(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  const auto groups = cases::stratum_groups(settings.families);
  std::vector<OffsetRow> rows;
  for (const auto& group : groups)
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const MethodErrors sum = errors.sum(group.strata, m);
      for (std::size_t i = 0; i < sum.offsets.size(); ++i)
        if (const Answers& at = sum.offsets[i]; at.trials > 0)
          rows.push_back({subject(settings, group, m), cases::all_offsets()[i], at, at.rate()});
    }
  errors_table().write(folder, rows);
}

void write_bands(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  const auto groups = cases::stratum_groups(settings.families);
  std::vector<BandRow> rows;
  for (const auto& group : groups)
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const MethodErrors sum = errors.sum(group.strata, m);
      const Answers near = sum.near_threshold();
      if (near.trials == 0) continue;
      // Samples are independent, answers are not.
      const auto limits = statistics::bounded_mean(near.share(), sum.samples);
      rows.push_back(
          {subject(settings, group, m), sum.samples, near, band_of(sum), {near.share(), limits.lower, limits.upper}});
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
          rows.push_back({{family_name, placement}, name(settings, m), kQuantities[q], sum.ulps[q]});
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

std::string table(const Settings& settings, const Errors& errors, const std::vector<Timing>& timings) {
  std::string text, piped;
  for (const cases::Method* method : settings.methods)
    if (method->through_pipe()) piped += fmt::format("{}{}", piped.empty() ? "" : ", ", method->name());
  if (!piped.empty())
    piped += ": timed through a pipe: a time includes writing and reading JSON, the pipe and two changes of process.\n";
  for (const Placement placement : {Placement::LatticeFrame, Placement::Rotated})
    text += fmt::format("\n{}: {}\n{}\n{}{}", to_string(placement),
                        placement == Placement::LatticeFrame ? "exactly planar polygons on an integer lattice"
                                                             : "rotated polygons, vertices rounded to doubles",
                        times_and_shares(settings, errors, timings, placement), units(settings, errors, placement),
                        fronts(settings, errors, timings, placement));
  return text + "\n" + piped + legend(timings);
}

}  // namespace touchstone::tradeoff
