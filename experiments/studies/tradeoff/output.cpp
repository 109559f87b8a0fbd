// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/tradeoff/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "experiments/cases/verdict.h"
#include "experiments/harness/write_file.h"
#include "experiments/methods/registry.h"
#include "experiments/statistics/bounded_mean.h"
#include "experiments/statistics/clopper_pearson.h"
#include "experiments/studies/tradeoff/band.h"
#include "experiments/studies/tradeoff/front.h"
#include "robust/exact/exact.h"

namespace touchstone::tradeoff {
namespace {

using cases::all_offsets;
using cases::all_strata;
using workloads::Placement;

constexpr std::array kPlacements{Placement::LatticeFrame, Placement::Rotated};

/// The subject of a line in the tables: one stratum, or one of each family.
struct Group {
  std::string name;  ///< family, placement and threshold
  std::vector<std::size_t> strata;
};

std::vector<Group> groups_of(const Settings& settings) {
  std::vector<Group> single, pooled;
  for (std::size_t s = 0; s < all_strata().size(); ++s) {
    const auto& [family, placement, threshold] = all_strata()[s];
    if (std::ranges::find(settings.families, family) == settings.families.end()) continue;
    const std::string where = fmt::format("{},{}", word(placement), word(threshold));
    single.push_back({fmt::format("{},{}", word(family), where), {s}});
    const std::string all = "all," + where;
    auto group = std::ranges::find(pooled, all, &Group::name);
    if (group == pooled.end()) group = pooled.insert(group, {all, {}});
    group->strata.push_back(s);
  }
  single.insert(single.end(), pooled.begin(), pooled.end());
  return single;
}

/// Three columns.
std::string share_and_limits(std::uint64_t count, std::uint64_t trials, const statistics::Limits& limits) {
  const double share = trials == 0 ? 0 : static_cast<double>(count) / static_cast<double>(trials);
  return fmt::format("{:.6g},{:.6g},{:.6g}", share, limits.lower, limits.upper);
}

/// Calls line(family or nothing, its name, placement) for each of the selected families, then for all together.
template <class Line>
void for_each_place(const Settings& settings, const Line& line) {
  for (const auto family : settings.families)
    for (const Placement placement : kPlacements) line(std::optional(family), word(family), placement);
  for (const Placement placement : kPlacements) line(std::nullopt, "all", placement);
}

std::string_view name(const Settings& settings, std::size_t method) { return settings.methods[method]->name(); }

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
  const std::string id = fmt::format("worst-{}-{}-{}-{}-{}-s{}-n{}", word(quantity), name(settings, method),
                                     word(family), word(placement), word(threshold), settings.seed, worst.n);
  const std::vector<std::string> tags{
      std::string(name(settings, method)), std::string(word(quantity)),
      std::isfinite(worst.ulps) ? fmt::format("{:.6g} ulps", worst.ulps) : "not finite"};
  return cases::to_line(cases::case_of(id, ball, crossing->polygon, tags, cases::object_of(expected)));
}

}  // namespace

void write_errors(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  std::string text = "family,placement,threshold,test,method,offset,wrong,overflowed,unsure,trials,rate,lower,upper\n";
  for (const Group& group : groups_of(settings)) {
    const auto test = word(test_at(all_strata()[group.strata.front()].threshold));
    for (std::size_t m = 0; m < settings.methods.size(); ++m)
      for (std::size_t i = 0; i < all_offsets().size(); ++i) {
        Tally tally;
        for (const std::size_t stratum : group.strata) tally += errors.at[stratum][m].offsets[i];
        if (tally.trials == 0) continue;
        text += fmt::format(
            "{},{},{},{},{},{},{},{},{}\n", group.name, test, name(settings, m), all_offsets()[i], tally.wrong,
            tally.overflowed, tally.unsure, tally.trials,
            share_and_limits(tally.wrong, tally.trials, statistics::clopper_pearson(tally.wrong, tally.trials)));
      }
  }
  harness::write_file(folder / "errors.csv", text);
}

void write_bands(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  std::string text =
      "family,placement,threshold,test,method,samples,wrong,overflowed,unsure,answers,rate,lower,upper,lowest_offset,"
      "highest_offset\n";
  for (const Group& group : groups_of(settings)) {
    const auto test = word(test_at(all_strata()[group.strata.front()].threshold));
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const MethodErrors sum = errors.sum(group.strata, m);
      const Tally near = sum.near_threshold();
      if (near.trials == 0) continue;
      const double share = static_cast<double>(near.wrong) / static_cast<double>(near.trials);
      const Band band = band_of(sum);
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", group.name, test, name(settings, m), sum.samples,
                          near.wrong, near.overflowed, near.unsure, near.trials,
                          share_and_limits(near.wrong, near.trials, statistics::bounded_mean(share, sum.samples)),
                          band.lowest ? std::to_string(*band.lowest) : "",
                          band.highest ? std::to_string(*band.highest) : "");
    }
  }
  harness::write_file(folder / "bands.csv", text);
}

void write_points(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  std::string text =
      "family,placement,method,quantity,asked,known,not_finite,correctly_rounded,median,q99,worst,worst_family,worst_"
      "threshold,"
      "worst_sample\n";
  for_each_place(settings, [&](auto family, std::string_view family_name, Placement placement) {
    const auto strata = strata_of(family, placement, true);
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const MethodErrors sum = errors.sum(strata, m);
      for (std::size_t q = 0; q < kQuantities.size(); ++q) {
        const UlpErrors& ulps = sum.ulps[q];
        const auto& [asked, known] = ulps;
        if (known.count() == known.infinite()) continue;
        const Worst& worst = sum.worst[q];
        const auto& stratum = all_strata()[worst.stratum];
        text += fmt::format(
            "{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{}\n", family_name, word(placement), name(settings, m),
            word(kQuantities[q]), asked, known.count(), known.infinite(), known.zeros(), ulps.quantile_of_finite(0.5),
            ulps.quantile_of_finite(0.99), ulps.quantile_of_finite(1),
            worst.ulps == 0 ? ",," : fmt::format("{},{},{}", word(stratum.family), word(stratum.threshold), worst.n));
      }
    }
  });
  harness::write_file(folder / "points.csv", text);
}

void write_worst(const std::filesystem::path& folder, const Settings& settings, const Errors& errors) {
  std::string text;
  for (const Placement placement : kPlacements)
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const MethodErrors sum = errors.sum(strata_of(std::nullopt, placement, true), m);
      for (std::size_t q = 0; q < kQuantities.size(); ++q)
        if (sum.worst[q].ulps > 0) text += worst_case(settings, m, kQuantities[q], sum.worst[q]);
    }
  harness::write_file(folder / "worst.jsonl", text);
}

void write_timings(const std::filesystem::path& folder, const std::vector<Timing>& timings) {
  std::string text =
      "family,placement,balls,question,method,asked,repetitions,lower_quartile_ns,median_ns,upper_quartile_ns\n";
  for (const auto& [place, balls, kind, methods] : timings)
    for (const timing::Measured& m : methods) {
      const auto q = timing::quartiles(m.nanoseconds);
      text += fmt::format("{},{},{},{},{},{},{},{:.1f},{:.1f},{:.1f}\n", word(place.family), word(place.placement),
                          word(balls), word(kind), m.name, m.queries, m.nanoseconds.size(), q.lower, q.median, q.upper);
    }
  harness::write_file(folder / "timings.csv", text);
}

void write_front(const std::filesystem::path& folder, const Settings& settings, const Errors& errors,
                 const std::vector<Timing>& timings) {
  std::string text =
      "measure,family,placement,method,nanoseconds,lower_quartile_ns,upper_quartile_ns,error,lower,upper,finite_error,"
      "not_finite,samples,front\n";
  for (const Measure measure : kMeasures)
    for_each_place(settings, [&](auto family, std::string_view family_name, Placement placement) {
      for (const Standing& s : standings(measure, family, placement, errors, timings))
        text += fmt::format("{},{},{},{},{:.1f},{:.1f},{:.1f},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{}\n",
                            word(measure), family_name, word(placement), name(settings, s.method), s.nanoseconds.median,
                            s.nanoseconds.lower, s.nanoseconds.upper, s.error, s.lower, s.upper, s.finite_error,
                            s.not_finite, s.samples, word(s.front));
    });
  harness::write_file(folder / "front.csv", text);
}

}  // namespace touchstone::tradeoff
