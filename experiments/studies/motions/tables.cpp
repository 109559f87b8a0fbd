// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "experiments/cases/verdict.h"
#include "experiments/program/output.h"
#include "experiments/studies/motions/measure.h"

namespace touchstone::motions {
namespace {

using cases::Failures;
using program::path;
using statistics::Distribution;

constexpr const char* kFormat = "{:.6g}";

struct WayRow {
  std::string_view way, method;
  MethodErrors errors;
  Failures all;
  program::Rate rate;
};

/// Returns a quantile, if there are any numbers.
auto quantile(Distribution TimeErrors::*errors, double share) {
  return [errors, share](const WayRow& row) {
    const Distribution& numbers = row.errors.times.*errors;
    return numbers.count() == 0 ? std::nullopt : std::optional(numbers.quantile(share));
  };
}

const program::Table<WayRow>& ways_table() {
  static const program::Table<WayRow> table(
      "ways.csv", "a way of the ball and a method",
      program::all_columns<WayRow>(
          {{{"way", "the way of the ball, as `touchstone cases --way` has it, or `all`", &WayRow::way},
            {"method", "the method", &WayRow::method},
            {"samples", "motions about which the method decides, which are independent",
             path(&WayRow::errors, path(&MethodErrors::samples, &Failures::trials))},
            {"failed", "motions about which an answer is wrong for any radius",
             path(&WayRow::errors, path(&MethodErrors::samples, &Failures::wrong))}},
           program::rate_columns<WayRow>("failed motions", &WayRow::rate),
           {{"answers", "answers to whether the ball touches", path(&WayRow::all, &Failures::trials)},
            {"missed", "wrong answers: contacts that the method denies", path(&WayRow::all, &Failures::wrongly_out)},
            {"invented", "wrong answers: contacts that the method invents", path(&WayRow::all, &Failures::wrongly_in)},
            {"unsure", "undecided answers", path(&WayRow::all, &Failures::unsure)},
            {"furthest", "the largest offset of a wrong answer, as a share of the polygon's size",
             [](const WayRow& row) {
               return row.errors.furthest.any ? std::optional(row.errors.furthest.share) : std::nullopt;
             }},
            {"found", "contacts that the method found", [](const WayRow& row) { return row.errors.times.found; }},
            {"timed", "those that are not at the start, and for which it gives a time",
             [](const WayRow& row) { return row.errors.times.ulps.count(); }},
            {"correctly_rounded", "times without error",
             [](const WayRow& row) { return row.errors.times.ulps.zeros(); }},
            {"median_ulps", "the median error of the times, in units in the last place",
             quantile(&TimeErrors::ulps, 0.5), kFormat},
            {"worst_ulps", "the largest one", quantile(&TimeErrors::ulps, 1), kFormat},
            {"median_size", "the median error of the place at that time, as a share of the polygon's size",
             quantile(&TimeErrors::ways, 0.5), kFormat},
            {"worst_size", "the largest one", quantile(&TimeErrors::ways, 1), kFormat}}}));
  return table;
}

struct ThresholdRow {
  Event event;
  Feature::Kind feature;
  std::string_view method;
  double offset;
  Failures answers;
  program::Rate rate;
};

const program::Table<ThresholdRow>& thresholds_table() {
  static const program::Table<ThresholdRow> table(
      "thresholds.csv", "an event, a feature, a method and an offset",
      program::all_columns<ThresholdRow>(
          {{{"event", "what a ball of the threshold radius does: start, graze or end in contact", &ThresholdRow::event},
            {"feature", "what it touches first", &ThresholdRow::feature},
            {"method", "the method", &ThresholdRow::method},
            {"offset", "the radius less its threshold, as a share of the polygon's size", &ThresholdRow::offset},
            {"trials", "motions, which are independent", path(&ThresholdRow::answers, &Failures::trials)},
            {"missed", "contacts that the method denies", path(&ThresholdRow::answers, &Failures::wrongly_out)},
            {"invented", "contacts that the method invents", path(&ThresholdRow::answers, &Failures::wrongly_in)},
            {"unsure", "undecided answers", path(&ThresholdRow::answers, &Failures::unsure)}},
           program::rate_columns<ThresholdRow>("wrong answers", &ThresholdRow::rate)}));
  return table;
}

const program::Table<Said>& pass_table() {
  static const program::Table<Said> table(
      "pass.csv", "what a method says about the grazing pass with a radius",
      {{"method", "the method", &Said::method},
       {"offset", "the radius less its threshold, as a share of the polygon's size", &Said::offset},
       {"truth", "1 if the ball touches", [](const Said& said) { return said.truth ? 1U : 0U; }},
       {"contact", "1 if the method says so; empty if it is unsure",
        [](const Said& said) { return said.contact ? std::optional(*said.contact ? 1U : 0U) : std::nullopt; }},
       {"time_error", "of a contact that it times: the error of the place, as a share of the polygon's size",
        &Said::time_error, kFormat}});
  return table;
}

struct Spot {
  std::string what;
  Eigen::Vector2d at;
};

const program::Table<Spot>& scene_table() {
  static const program::Table<Spot> table(
      "pass-scene.csv", "a point of the grazing pass as the picture has it",
      {{"what", "`from`, `to`, `center` (at the first contact), or `loop` and the number of a vertex's loop",
        &Spot::what},
       {"x", "along the way, as a share of the polygon's size", [](const Spot& s) { return s.at.x(); }, kFormat},
       {"y", "from the point touched to the centre, likewise", [](const Spot& s) { return s.at.y(); }, kFormat}});
  return table;
}

std::vector<WayRow> way_rows(const Settings& settings, const Errors& errors, bool each_way) {
  std::vector<WayRow> rows;
  const auto add = [&](std::string_view way, const auto& wanted) {
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const MethodErrors sum = errors.sum(m, wanted);
      if (sum.samples.trials > 0)
        rows.push_back({way, settings.methods[m]->name(), sum, cases::total(sum.offsets), sum.samples.rate()});
    }
  };
  if (each_way)
    for (const auto way : kWays) add(to_string(way), [way](const Kind& kind) { return kind.way == way; });
  add("all", [](const Kind&) { return true; });
  return rows;
}

std::vector<ThresholdRow> threshold_rows(const Settings& settings, const Errors& errors) {
  std::vector<ThresholdRow> rows;
  for (const Event event : kEvents)
    for (const auto feature : kFeatures)
      for (std::size_t m = 0; m < settings.methods.size(); ++m) {
        const MethodErrors sum =
            errors.sum(m, [&](const Kind& kind) { return kind.event == event && kind.feature == feature; });
        for (std::size_t i = 0; i < all_offsets().size(); ++i)
          if (const Failures& answers = sum.offsets[i]; answers.trials > 0)
            rows.push_back({event, feature, settings.methods[m]->name(), all_offsets()[i], answers, answers.rate()});
      }
  return rows;
}

}  // namespace

void write_errors(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  ways_table().write(folder, way_rows(settings, errors, true));
  thresholds_table().write(folder, threshold_rows(settings, errors));
}

void write_furthest(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  std::string text;
  for (std::size_t m = 0; m < settings.methods.size(); ++m) {
    const auto [share, n, stratum, offset, any] = errors.sum(m, [](const Kind&) { return true; }).furthest;
    if (!any) continue;
    const auto at = draw_at_threshold(stratum, settings.vertices, settings.seed, n);
    const cases::Shapes shapes{at->moved(all_offsets()[offset]).value(), at->polygon};
    const auto name = std::string(settings.methods[m]->name());
    text +=
        cases::case_line(fmt::format("furthest-{}-s{}-n{}-{}", name, settings.seed, n, stratum), shapes,
                         {name, std::string(to_string(at->event)), fmt::format("offset {:.6g}", all_offsets()[offset])},
                         exact_answer(shapes));
  }
  program::write_file(folder / "furthest.jsonl", text);
}

void write_pass(const std::filesystem::path& folder, const GrazingPass& pass, const std::vector<Said>& said) {
  pass_table().write(folder, said);
  const auto& [polygon, motion, event, feature] = pass.at;
  std::vector<Spot> spots{
      {"from", pass.seen(motion.ball.center)},
      {"to", pass.seen(motion.to)},
      {"center", pass.seen(motion.ball.center + pass.first.time * (motion.to - motion.ball.center))}};
  for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop)
    for (std::size_t i = polygon.loop_begin(loop); i < polygon.loop_end(loop); ++i)
      spots.push_back({fmt::format("loop {}", loop), pass.seen(polygon.vertex(i))});
  scene_table().write(folder, spots);
}

std::vector<program::TableDescription> tables() {
  return {ways_table().description(), thresholds_table().description(), pass_table().description(),
          scene_table().description()};
}

std::string table(const Settings& settings, const Errors& errors) {
  return ways_table().aligned(way_rows(settings, errors, false));
}

}  // namespace touchstone::motions
