// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/tradeoff/front.h"

#include <algorithm>

#include "experiments/program/statistics/shares.h"

namespace touchstone::tradeoff {
namespace {

using cases::QueryKind;

/// Beyond the noise.
bool faster(const ParetoEntry& a, const ParetoEntry& b) { return a.nanoseconds.upper < b.nanoseconds.lower; }

Front front_of(const ParetoEntry& s, const std::vector<ParetoEntry>& entries) {
  Front front = Front::On;
  for (const ParetoEntry& other : entries) {
    if (&other == &s || other.error > s.error || faster(s, other)) continue;
    if (faster(other, s)) return Front::Off;
    front = Front::WithinNoise;
  }
  return front;
}

/// The means of the quartiles of the lists near thresholds.
std::optional<Nanoseconds> nanoseconds(std::size_t method, QueryKind kind, std::optional<workloads::Family> family,
                                       workloads::Placement placement, const std::vector<Timing>& timings) {
  Nanoseconds sum{0, 0, 0};
  int lists = 0;
  for (const Timing& t : timings) {
    if (t.balls != Balls::Near || t.kind != kind || t.group.placement != placement) continue;
    if (family && t.group.family != *family) continue;
    const auto q = timing::quartiles(t.methods[method].nanoseconds);
    sum = {sum.lower + q.lower, sum.median + q.median, sum.upper + q.upper};
    ++lists;
  }
  if (lists == 0) return std::nullopt;
  return Nanoseconds{sum.lower / lists, sum.median / lists, sum.upper / lists};
}

std::optional<ParetoEntry> entry(Measure measure, const MethodErrors& errors, std::uint64_t polygons) {
  if (measure == Measure::NotRight) {
    const Answers near = errors.near_threshold();
    if (near.trials == 0) return std::nullopt;
    const auto trials = static_cast<double>(near.trials);
    const double share = static_cast<double>(near.not_right()) / trials;
    const auto limits = statistics::bounded_mean(share, polygons);
    return ParetoEntry{.method = 0,
                       .nanoseconds = {},
                       .error = share,
                       .lower = limits.lower,
                       .upper = limits.upper,
                       .finite_error = share,
                       .not_finite = static_cast<double>(near.overflowed) / trials,
                       .samples = polygons};
  }
  if (measure == Measure::Reach) {
    if (errors.near_threshold().trials == 0) return std::nullopt;
    const double reach = errors.reach();
    return ParetoEntry{.method = 0,
                       .nanoseconds = {},
                       .error = reach,
                       .lower = reach,
                       .upper = reach,
                       .finite_error = reach,
                       .not_finite = 0,
                       .samples = polygons};
  }
  const UlpErrors& ulps =
      errors.ulps[static_cast<std::size_t>(measure == Measure::Distance ? Quantity::Distance : Quantity::Point)];
  const std::uint64_t known = ulps.known.count(), infinite = ulps.known.infinite();
  if (known == infinite || 2 * known < ulps.asked) return std::nullopt;
  return ParetoEntry{.method = 0,
                     .nanoseconds = {},
                     .error = ulps.known.quantile(0.99),
                     .lower = ulps.quantile_of_finite(0.5),
                     .upper = ulps.quantile_of_finite(1),
                     .finite_error = ulps.quantile_of_finite(0.99),
                     .not_finite = static_cast<double>(infinite) / static_cast<double>(known),
                     .samples = std::min(known, polygons)};
}

}  // namespace

std::string_view to_string(Measure measure) {
  switch (measure) {
    case Measure::NotRight: return "not-right";
    case Measure::Reach: return "reach";
    case Measure::Distance: return "distance";
    case Measure::Point: break;
  }
  return "point";
}

std::string_view to_string(Front front) {
  switch (front) {
    case Front::On: return "on";
    case Front::WithinNoise: return "within-noise";
    case Front::Off: break;
  }
  return "off";
}

void mark_front(std::vector<ParetoEntry>& entries) {
  for (ParetoEntry& s : entries) s.front = front_of(s, entries);
}

std::vector<std::size_t> strata_of(std::optional<workloads::Family> family, workloads::Placement placement,
                                   bool radius) {
  std::vector<std::size_t> strata;
  for (std::size_t s = 0; s < cases::all_strata().size(); ++s) {
    const auto& stratum = cases::all_strata()[s];
    if (stratum.placement == placement && cases::moves_radius(stratum.threshold) == radius &&
        (!family || stratum.family == *family))
      strata.push_back(s);
  }
  return strata;
}

std::vector<ParetoEntry> pareto_entries(Measure measure, std::optional<workloads::Family> family,
                                        workloads::Placement placement, const Errors& errors,
                                        const std::vector<Timing>& timings) {
  const bool of_contact = measure == Measure::NotRight || measure == Measure::Reach;
  const QueryKind kind = of_contact ? QueryKind::Contact : QueryKind::Answer;
  const auto strata = strata_of(family, placement, true);
  const std::size_t methods = errors.at.front().size();
  std::vector<ParetoEntry> list;
  for (std::size_t m = 0; m < methods; ++m) {
    auto found = entry(measure, errors.sum(strata, m), errors.polygons(strata, m));
    const auto time = nanoseconds(m, kind, family, placement, timings);
    if (!found || !time) continue;
    found->method = m;
    found->nanoseconds = *time;
    list.push_back(*found);
  }
  mark_front(list);
  return list;
}

}  // namespace touchstone::tradeoff
