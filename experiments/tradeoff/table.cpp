// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "experiments/statistics/bounded_mean.h"
#include "experiments/tradeoff/band.h"
#include "experiments/tradeoff/front.h"
#include "experiments/tradeoff/output.h"

namespace touchstone::tradeoff {
namespace {

using methods::Question;
using workloads::Placement;

std::string three_digits(double value) {
  if (!std::isfinite(value)) return "inf";
  if (value == 0 || (value >= 1 && value < 1e5))
    return fmt::format("{:.{}f}", value, value < 10 && value != std::floor(value) ? 1 : 0);
  return fmt::format("{:.2g}", value);
}

std::string percent(double share) {
  if (share == 0) return "0";
  if (share == 1) return "100";
  return share < 0.0095 ? fmt::format("{:.2g}", 100 * share) : fmt::format("{:.1f}", 100 * share);
}

/// The mean over all places of a placement; how many were asked, in the list of the fewest and of the most.
struct Times {
  double nanoseconds = 0;
  std::size_t lists = 0, fewest = 0, most = 0;
};

Times times_of(std::size_t method, Balls balls, Question question, Placement placement,
               const std::vector<Timing>& timings) {
  Times times;
  for (const Timing& t : timings) {
    if (t.balls != balls || t.question != question || t.place.placement != placement) continue;
    const bench::Measured& measured = t.methods[method];
    times.nanoseconds += bench::quartiles(measured.nanoseconds).median;
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
    return fmt::format("  {:<19}{:>8}{:>9}{:>9}{:>9}  {:<11}{:>6}  {:<15}{:>7}  {}\n", cells...);
  };
  std::string text = row("", "contact", "contact", "answer", "answer", "", "wrong", "95 %", "don't", "wrong at");
  text += row("nanoseconds", "near", "anywhere", "near", "anywhere", "asked", "%", "limits", "know %", "offsets");
  for (std::size_t m = 0; m < settings.methods.size(); ++m) {
    const MethodErrors sum = errors.sum(strata_of(std::nullopt, placement, true), m);
    const Tally near = sum.near_threshold();
    const auto share = [&](std::uint64_t count) {
      return near.trials == 0 ? 0 : static_cast<double>(count) / static_cast<double>(near.trials);
    };
    const auto limits = statistics::bounded_mean(share(near.wrong), sum.samples);
    const auto time = [&](Balls balls, Question question) { return times_of(m, balls, question, placement, timings); };
    text += row(settings.methods[m]->name(), time_text(time(Balls::Near, Question::Contact)),
                time_text(time(Balls::Anywhere, Question::Contact)), time_text(time(Balls::Near, Question::Answer)),
                time_text(time(Balls::Anywhere, Question::Answer)), asked_text(time(Balls::Near, Question::Contact)),
                percent(share(near.wrong)), percent(limits.lower) + " to " + percent(limits.upper),
                percent(share(near.unsure)), text_of(band_of(sum)));
  }
  return text;
}

std::string units(const Settings& settings, const Errors& errors, Placement placement) {
  const auto row = [](auto... cells) {
    return fmt::format("  {:<19}{:>9}{:>9}{:>10}{:>10}{:>12}   {:>9}{:>10}{:>10}{:>12}\n", cells...);
  };
  std::string text = row("", "", "distance:", "", "", "", "point:", "", "", "");
  text += row("units in last place", "asked", "known", "median", "99 %", "worst", "known", "median", "99 %", "worst");
  for (std::size_t m = 0; m < settings.methods.size(); ++m) {
    const MethodErrors sum = errors.sum(strata_of(std::nullopt, placement, true), m);
    const auto& [distance, point] = sum.ulps;
    if (distance.known.count() == 0 && point.known.count() == 0) continue;
    const auto cell = [](const UlpErrors& e, double q) {
      return e.known.count() == 0 ? "-" : three_digits(e.known.quantile(q));
    };
    text += row(settings.methods[m]->name(), distance.asked, distance.known.count(), cell(distance, 0.5),
                cell(distance, 0.99), cell(distance, 1), point.known.count(), cell(point, 0.5), cell(point, 0.99),
                cell(point, 1));
  }
  return text;
}

std::string legend(const std::vector<Timing>& timings) {
  std::string text = fmt::format(
      "Times: nanoseconds a question about a prepared polygon, through the common interface; means over the families\n"
      "of medians of the repetitions, in which all methods take turns on one list of distinct balls. near: the radius\n"
      "is within {} doubles of the distance. asked: how many of the list of contact, near; a slow method gets the\n"
      "first ones, as many as fit into {:g} ms. wrong, don't know: answers to contact within {} doubles of the radius\n"
      "that just touches; limits: Hoeffding, 95 %, samples being independent. Slow methods were asked about one "
      "sample\n"
      "in {}. wrong at offsets: the lowest and the highest, in doubles, of those tried, up to 2^32.\n"
      "Units in the last place: of the exact distance, and of the largest coordinate of the exact point; both "
      "correctly\n"
      "rounded, so that 0 is within half a unit of the truth. Methods that give neither are left out.\n",
      kNear, 1e3 * kSecondsOfList, kNear, kSlowStride);
  if (timings.empty()) text += "Nothing was timed.\n";
  return text;
}

}  // namespace

std::string table(const Settings& settings, const Errors& errors, const std::vector<Timing>& timings) {
  std::string text;
  for (const Placement placement : {Placement::LatticeFrame, Placement::Rotated})
    text += fmt::format("\n{}: {}\n{}\n{}", word(placement),
                        placement == Placement::LatticeFrame ? "exactly planar polygons on an integer lattice"
                                                             : "rotated polygons, vertices rounded to doubles",
                        times_and_shares(settings, errors, timings, placement), units(settings, errors, placement));
  return text + "\n" + legend(timings);
}

}  // namespace touchstone::tradeoff
