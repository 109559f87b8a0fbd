// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/tradeoff/front.h"

#include <algorithm>

#include "experiments/statistics/bounded_mean.h"

namespace touchstone::tradeoff {
namespace {

using methods::Question;

bool dominates(const Standing& a, const Standing& b) {
  return a.nanoseconds <= b.nanoseconds && a.error <= b.error && (a.nanoseconds < b.nanoseconds || a.error < b.error);
}

/// The mean of the medians of the lists near thresholds.
std::optional<double> nanoseconds(std::size_t method, Question question, std::optional<workloads::Family> family,
                                  workloads::Placement placement, const std::vector<Timing>& timings) {
  double sum = 0;
  int lists = 0;
  for (const Timing& t : timings) {
    if (t.balls != Balls::Near || t.question != question || t.place.placement != placement) continue;
    if (family && t.place.family != *family) continue;
    sum += bench::quartiles(t.methods[method].nanoseconds).median;
    ++lists;
  }
  return lists == 0 ? std::nullopt : std::optional(sum / lists);
}

std::optional<Standing> standing(Measure measure, const MethodErrors& errors) {
  if (measure == Measure::NotRight) {
    const Tally tally = errors.near_threshold();
    if (tally.trials == 0) return std::nullopt;
    const double share = static_cast<double>(tally.not_right()) / static_cast<double>(tally.trials);
    const auto limits = statistics::bounded_mean(share, errors.samples);
    return Standing{0, 0, share, limits.lower, limits.upper, errors.samples};
  }
  const UlpErrors& ulps =
      errors.ulps[static_cast<std::size_t>(measure == Measure::Distance ? Quantity::Distance : Quantity::Point)];
  const std::uint64_t known = ulps.known.count();
  if (known == 0 || 2 * known < ulps.asked) return std::nullopt;
  return Standing{0, 0, ulps.known.quantile(0.99), ulps.known.quantile(0.5), ulps.known.largest(), known};
}

}  // namespace

std::string_view word(Measure measure) {
  switch (measure) {
    case Measure::NotRight: return "not-right";
    case Measure::Distance: return "distance";
    case Measure::Point: break;
  }
  return "point";
}

void mark_front(std::vector<Standing>& standings) {
  for (Standing& s : standings)
    s.on_front = std::ranges::none_of(standings, [&](const Standing& other) { return dominates(other, s); });
}

std::vector<std::size_t> strata_of(std::optional<workloads::Family> family, workloads::Placement placement,
                                   bool radius) {
  std::vector<std::size_t> strata;
  for (std::size_t s = 0; s < near_edge::all_strata().size(); ++s) {
    const auto& stratum = near_edge::all_strata()[s];
    if (stratum.placement == placement && near_edge::moves_radius(stratum.threshold) == radius &&
        (!family || stratum.family == *family))
      strata.push_back(s);
  }
  return strata;
}

std::vector<Standing> standings(Measure measure, std::optional<workloads::Family> family,
                                workloads::Placement placement, const Errors& errors,
                                const std::vector<Timing>& timings) {
  const Question question = measure == Measure::NotRight ? Question::Contact : Question::Answer;
  const auto strata = strata_of(family, placement, true);
  const std::size_t methods = errors.at.front().size();
  std::vector<Standing> list;
  for (std::size_t m = 0; m < methods; ++m) {
    auto found = standing(measure, errors.sum(strata, m));
    const auto time = nanoseconds(m, question, family, placement, timings);
    if (!found || !time) continue;
    found->method = m;
    found->nanoseconds = *time;
    list.push_back(*found);
  }
  mark_front(list);
  return list;
}

}  // namespace touchstone::tradeoff
