// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "experiments/run/statistics/bounded_mean.h"
#include "experiments/run/statistics/percent.h"
#include "experiments/studies/tradeoff/band.h"
#include "experiments/studies/tradeoff/front.h"
#include "experiments/studies/tradeoff/output.h"

namespace touchstone::tradeoff {
namespace {

using cases::QueryKind;
using workloads::Placement;

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
    const Tally near = sum.near_threshold();
    const auto share = [&](std::uint64_t count) {
      return near.trials == 0 ? 0 : static_cast<double>(count) / static_cast<double>(near.trials);
    };
    const auto cell = [&](const std::string& said) { return near.trials == 0 ? "-" : said; };  // it has no such test
    const auto limits = statistics::bounded_mean(share(near.wrong), errors.polygons(strata, m));
    const auto time = [&](Balls balls, QueryKind kind) { return times_of(m, balls, kind, placement, timings); };
    text += row(settings.methods[m]->name(), time_text(time(Balls::Near, QueryKind::Contact)),
                time_text(time(Balls::Anywhere, QueryKind::Contact)), time_text(time(Balls::Near, QueryKind::Answer)),
                time_text(time(Balls::Anywhere, QueryKind::Answer)), asked_text(time(Balls::Near, QueryKind::Contact)),
                cell(percent(share(near.wrong))), cell(percent(limits.lower) + " to " + percent(limits.upper)),
                cell(percent(share(near.overflowed))), cell(percent(share(near.unsure))), cell(text_of(band_of(sum))));
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
