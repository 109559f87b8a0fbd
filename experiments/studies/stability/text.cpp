// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include "experiments/run/statistics/shares.h"
#include "experiments/studies/stability/summary.h"

namespace touchstone::stability {
namespace {

constexpr std::size_t kWidth = 120;  // columns of the terminal
constexpr std::size_t kName = 18, kColumn = 17, kMostMethods = (kWidth - kName) / kColumn;

std::string limits_text(std::uint64_t failed, std::uint64_t trials) {
  const auto limits = statistics::clopper_pearson(failed, trials);
  return fmt::format("{} - {} %", statistics::percent_to_digits(limits.lower, 3),
                     statistics::percent_to_digits(limits.upper, 3));
}

std::string percent(std::uint64_t failed, std::uint64_t trials) {
  return statistics::percent_to_digits(statistics::share_of(failed, trials), 3) + " %";
}

/// A line of a table; cell(method) is what is said of each.
template <class Cell>
std::string row(const std::string& name, std::size_t begin, std::size_t end, const Cell& cell) {
  std::string text = fmt::format("{:<{}}", name, kName);
  for (std::size_t m = begin; m < end; ++m) text += fmt::format("{:>{}}", cell(m), kColumn);
  return text + "\n";
}

/// As many methods as fit stand side by side; rows(begin, end) are the lines about those.
template <class Rows>
std::string by_method(const Settings& settings, const std::string& head, const Rows& rows) {
  std::string text;
  for (std::size_t begin = 0; begin < settings.methods.size(); begin += kMostMethods) {
    const std::size_t end = std::min(settings.methods.size(), begin + kMostMethods);
    text += row(head, begin, end, [&](std::size_t m) { return settings.methods[m]->name(); }) + rows(begin, end);
  }
  return text;
}

/// cell(axis, method) is what is said of each, for the axes of which `shown` is true.
template <class Shown, class Cell>
std::string by_axis_and_method(const Settings& settings, const Shown& shown, const Cell& cell) {
  return by_method(settings, "axis", [&](std::size_t begin, std::size_t end) {
    std::string text;
    for (std::size_t a = 0; a < settings.axes.size(); ++a)
      if (shown(settings.axes[a]))
        text += row(std::string(to_string(settings.axes[a])), begin, end, [&](std::size_t m) { return cell(a, m); });
    return text;
  });
}

/// Returns whether the level is a number that gets worse (not a mode).
bool is_graded(Axis axis) { return axis != Axis::Rounding && axis != Axis::Flush; }

std::string first_failures(const Settings& settings, const Summary& summary, Nearness nearness) {
  return by_axis_and_method(settings, is_graded, [&](std::size_t axis, std::size_t method) -> std::string {
    const auto first = summary.first_level(settings, axis, nearness, Test::Contact, method, 0);
    const auto half = summary.first_level(settings, axis, nearness, Test::Contact, method, 0.5);
    if (!first) return "-";
    const auto& all = levels(settings.axes[axis]);
    return all[*first].name + (half ? " | " + all[*half].name : "");
  });
}

/// Returns the number of polygons at a level, and the upper limit of the share that fails if none did; axes that agree
/// share a line.
std::string limits_of_none(const Settings& settings, const Summary& summary) {
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::string, std::greater<>> axes;  // by the most and the fewest
  for (std::size_t axis = 0; axis < settings.axes.size(); ++axis) {
    if (!is_graded(settings.axes[axis])) continue;
    std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max(), most = 0;
    for (const auto& [cell, failures] : summary.failures) {
      const auto& [of_axis, nearness, test, method, level] = cell;
      if (of_axis != axis || nearness != Nearness::OneDouble || test != Test::Contact) continue;
      fewest = std::min(fewest, failures.samples.trials);
      most = std::max(most, failures.samples.trials);
    }
    if (most == 0) continue;  // no method has that test
    axes[{most, fewest}].append(" ").append(to_string(settings.axes[axis]));
  }
  const auto upper = [](std::uint64_t samples) { return 100 * statistics::clopper_pearson(0, samples).upper; };
  std::string text = "\nPolygons at a level, and the upper limit (95 %) of the share that fails if none of them did:\n";
  for (const auto& [count, names] : axes) {
    const auto [most, fewest] = count;
    text += most == fewest
                ? fmt::format("  {}, {:.2g} %:{}\n", most, upper(most), names)
                : fmt::format("  {} to {}, {:.2g} to {:.2g} %:{}\n", most, fewest, upper(most), upper(fewest), names);
  }
  return text;
}

std::string_view distance_words(Nearness nearness) {
  switch (nearness) {
    case Nearness::OneDouble: return "at the exact distance, or one double to either side";
    case Nearness::Close: return "2^-30 of the distance to either side";
    case Nearness::Ample: break;
  }
  return "a quarter of the distance to either side";
}

std::string largest_errors(const Settings& settings, const Summary& summary) {
  const auto every = [](Axis) { return true; };
  return by_axis_and_method(settings, every, [&](std::size_t axis, std::size_t method) -> std::string {
    double largest = -1;
    std::size_t worst = 0;
    for (std::size_t level = 0; level < levels(settings.axes[axis]).size(); ++level) {
      const auto found = summary.errors.find({axis, Quantity::Distance, method, level});
      if (found == summary.errors.end() || found->second.largest() <= largest) continue;
      largest = found->second.largest();
      worst = level;
    }
    if (largest < 0) return "";
    return largest == 0 ? "0" : fmt::format("{:.0e} at {}", largest, levels(settings.axes[axis])[worst].name);
  });
}

/// The rates in each floating-point mode of one axis, whose scenes are the same in all of them.
std::string mode_rates(const Settings& settings, const Summary& summary, std::size_t axis) {
  const auto& modes = levels(settings.axes[axis]);
  std::uint64_t polygons = 0;
  const auto rows = [&](std::size_t begin, std::size_t end) {
    std::string text;
    for (const Nearness nearness : kNearnesses)
      for (std::size_t level = 0; level < modes.size(); ++level)
        text += row(fmt::format("{:<7} {}", modes[level].name, to_string(nearness)), begin, end,
                    [&](std::size_t m) -> std::string {
                      const SampledFailures* failures = summary.at(axis, nearness, Test::Contact, m, level);
                      if (failures == nullptr) return "";
                      polygons = std::max(polygons, failures->samples.trials);
                      return percent(failures->samples.wrong, failures->samples.trials);
                    });
    return text;
  };
  const std::string table = by_method(settings, "mode, radius", rows);
  const bool rounding = settings.axes[axis] == Axis::Rounding;
  return fmt::format(
      "\n{}: samples with a wrong final answer, of the same {} polygons{}\nin each mode (0 %: at most {:.2g} "
      "%, with 95 %)\n{}",
      rounding ? "Rounding directions (fast and thesis promise round to nearest only)" : "Subnormals flushed", polygons,
      rounding ? "" : ", with subnormal coordinates or products,", 100 * statistics::clopper_pearson(0, polygons).upper,
      table);
}

std::string all_mode_rates(const Settings& settings, const Summary& summary) {
  std::string text;
  for (std::size_t axis = 0; axis < settings.axes.size(); ++axis)
    if (!is_graded(settings.axes[axis])) text += mode_rates(settings, summary, axis);
  return text;
}

std::string totals(const Settings& settings, const Summary& summary) {
  std::string text;
  for (std::size_t m = 0; m < settings.methods.size(); ++m) {
    const auto& [samples, answers] = summary.total(settings, m);
    if (answers.trials == 0) continue;
    if (answers.wrong == 0)
      text += fmt::format(
          "{}: none of {} answers to all five tests about {} polygons was wrong: at most {:.2g} of such polygons (95 "
          "%).\n",
          settings.methods[m]->name(), answers.trials, samples.trials, samples.rate().upper);
    else
      text += fmt::format("{}: {} of {} answers to all five tests about {} polygons were wrong.\n",
                          settings.methods[m]->name(), answers.wrong, answers.trials, samples.trials);
  }
  if (summary.confirmed + summary.disputed > 0)
    text += fmt::format(
        "Truth: exact; on more than {} vertices filtered, with exact asked again about one ball per polygon and\n"
        "about every ball on which a method failed: {} confirmed, {}.\n",
        Oracle::kMostForExact, summary.confirmed,
        summary.disputed == 0 ? "none disputed" : fmt::format("{} DISPUTED", summary.disputed));
  return text;
}

std::string bounds_table(const Summary& summary) {
  if (summary.all_bounds.empty()) return {};
  std::string text = fmt::format(
      "\nBounds on rounding errors: |computed - exact| / bound, over all axes\n"
      "  {:<15}{:<9}{:>13}{:>10}{:>16}{:>10}{:>10}{:>10}\n",
      "stage", "sign", "observations", "exceeded", "limit, polygons", "median", "99 %", "max");
  for (const auto& [quantity, bound] : summary.all_bounds) {
    const BoundedQuantity& about = bounded_quantities()[quantity];
    text += fmt::format("  {:<15}{:<9}{:>13}{:>10}{:>16}{:>10.2g}{:>10.2g}{:>10.2g}\n", to_string(about.stage),
                        about.name, bound.tightness.count(), bound.exceeded,
                        fmt::format("{:.2g} %", 100 * statistics::clopper_pearson(bound.failed, bound.polygons).upper),
                        bound.tightness.quantile(0.5), bound.tightness.quantile(0.99), bound.tightness.largest());
  }
  return text +
         "All bounds except fast-planarity are proved (robust/proofs); `fast` states that one for its own heights.\n"
         "The bounds of maxima and frame hold in every rounding direction, for a unit of 2^-52; rounding to nearest\n"
         "needs half of that.\n";
}

/// The share of wrong answers, with its limits: two answers of a triangle are not independent, triangles are.
std::string wrong_text(const Onset& onset, std::size_t distance, std::size_t method, int k) {
  const auto triangles = static_cast<double>(onset.triangles());
  const double share = static_cast<double>(onset.wrong(distance, method, k)) / (2 * triangles);
  const auto limits = statistics::bounded_mean(share, onset.triangles());
  return fmt::format("{:.1f} ({:.1f} - {:.1f})", 100 * share, 100 * limits.lower, 100 * limits.upper);
}

std::string onset_table(const Onset& onset) {
  if (onset.triangles() == 0) return {};
  constexpr int kKnown[] = {51, 36};  // at the distances
  const auto line = [](auto... cells) {
    return fmt::format("  {:<17}{:>8}{:>9}{:>10}{:>19}{:>12}{:>9}{:>10}{:>19}\n", cells...);
  };
  const auto k_text = [](int k) {
    return k == 0 ? std::string("-") : fmt::format("{}2^-{}", k == kCoarsest ? ">=" : "", k);
  };
  std::string text = fmt::format(
      "\nKnown results: the radius differs by 2^-k of the exact distance to a triangle's face, to either side; {} "
      "triangles\n",
      onset.triangles());
  text += line("about the origin:", "first", "from 1 %", "from 50 %", fmt::format("answers at {}, %", kKnown[0]),
               "1e6 away:", "from 1 %", "from 50 %", fmt::format("answers at {}, %", kKnown[1]));
  for (std::size_t m = 0; m < onset.methods().size(); ++m)
    text += line(onset.methods()[m], k_text(onset.first(0, m, 0)), k_text(onset.first(0, m, 0.01)),
                 k_text(onset.first(0, m, 0.5)), wrong_text(onset, 0, m, kKnown[0]), k_text(onset.first(1, m, 0)),
                 k_text(onset.first(1, m, 0.01)), k_text(onset.first(1, m, 0.5)), wrong_text(onset, 1, m, kKnown[1]));
  return text +
         fmt::format(
             "First, from: the coarsest 2^-k at which one triangle, 1 % or half of them fail; a triangle has "
             "one answer above\n"
             "and one below. Answers at k: the share of wrong ones, with 95 % limits. 1e6 away: in sizes.\n"
             "Known for naive doubles (ericson-absolute): 2^-{} around the origin, where wrong answers also begin "
             "here; and 2^-{}\n"
             "1e6 away (38 % of answers wrong). There wrong answers are common; the first ones appear at "
             "offsets 2^20 times as\n"
             "coarse as around the origin, like the rounding errors of the coordinates.\n",
             kKnown[0], kKnown[1]) +
         "Methods that start with differences of the input lose no accuracy far from the origin, since "
         "the vertices of a\n"
         "triangle are always in its plane; methods that compute a point (ericson-absolute) or a plane's "
         "offset (thesis) lose\n"
         "as much as the coordinates.\n";
}

std::string contraction_table(const std::vector<ContractionCount>& counts) {
  std::string text = fmt::format(
      "\nContraction to fused multiply-adds, written out with std::fma: wrong signs\n"
      "  {:<13}{:<19}{:>8}{:>10}  {:<20}{:>10}  {:<20}{:>12}\n",
      "sign", "exact value", "trials", "plain", "95 % limits", "fused", "95 % limits", "they differ");
  for (const ContractionCount& c : counts)
    text += fmt::format("  {:<13}{:<19}{:>8}{:>10}  {:<20}{:>10}  {:<20}{:>12}\n", c.sign, c.family, c.trials,
                        percent(c.plain_wrong, c.trials), limits_text(c.plain_wrong, c.trials),
                        percent(c.fused_wrong, c.trials), limits_text(c.fused_wrong, c.trials),
                        percent(c.differ, c.trials));
  return text;
}

std::string legend(const Settings& settings) {
  std::string text =
      "\n"
      "A sample is a polygon under stress and balls near it; it fails if the answer is wrong for any ball.\n"
      "A | B: the first level with a failure, and the first at which more than half of the samples "
      "failed; -: none seen.\n"
      "errors.csv also has the closest point: if two features are equally near, rounding may choose the "
      "other, far away.\n"
      "An exception of a method counts as wrong. chain, pose: -input tests methods on the doubles at the "
      "end of a chain,\n"
      "-motion includes the error of the chain itself, which filtered, exact on those doubles, shows alone.\n"
      "Axes:\n";
  for (const Axis axis : settings.axes) {
    text += fmt::format("  {:<18} {}: {} to {}", to_string(axis), meaning(axis), levels(axis).front().name,
                        levels(axis).back().name);
    std::uint64_t rarest = 1;
    for (const Level& level : levels(axis)) rarest = std::max(rarest, level.one_in);
    text += rarest > 1 ? fmt::format("; last: 1 in {}\n", rarest) : "\n";
  }
  return text;
}

}  // namespace

std::string table(const Settings& settings, const Summary& summary, const Known& known) {
  std::string text = "Where each method first fails: the final answer (contact or not), by nearness of the ball\n";
  for (const Nearness nearness : kNearnesses)
    text += fmt::format("\n{}: radius {}\n", to_string(nearness), distance_words(nearness)) +
            first_failures(settings, summary, nearness);
  if (!summary.failures.empty()) text += limits_of_none(settings, summary);
  text += all_mode_rates(settings, summary);
  text += "\nThe largest relative error of the distance (inf: not finite)\n" + largest_errors(settings, summary) +
          "\n" + totals(settings, summary);
  return text + bounds_table(summary) + onset_table(known.onset) + contraction_table(known.contractions) +
         legend(settings);
}

}  // namespace touchstone::stability
