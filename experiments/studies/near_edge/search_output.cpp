// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "experiments/harness/write_file.h"
#include "experiments/statistics/clopper_pearson.h"
#include "experiments/statistics/percent.h"
#include "experiments/studies/near_edge/output.h"

namespace touchstone::near_edge {
namespace {

std::string_view test_word(cases::Threshold threshold) {
  return word(cases::moves_radius(threshold) ? Test::Contact : Test::Foot);
}

/// Regions that differ in their family alone.
struct RegionGroup {
  std::string family;
  cases::Threshold threshold;
  double distance;
  std::vector<std::size_t> regions;
};

std::vector<RegionGroup> pooled_groups(const Settings& settings) {
  std::vector<RegionGroup> groups;
  const auto regions = search_regions(settings.families);
  for (const cases::Threshold threshold : cases::all_thresholds())
    for (const double distance : kSearchDistances) {
      RegionGroup group{"all", threshold, distance, {}};
      for (std::size_t r = 0; r < regions.size(); ++r)
        if (cases::all_strata()[regions[r].stratum].threshold == threshold && regions[r].origin_distance == distance)
          group.regions.push_back(r);
      if (!group.regions.empty()) groups.push_back(std::move(group));
    }
  return groups;
}

std::vector<RegionGroup> region_groups(const Settings& settings) {
  std::vector<RegionGroup> groups;
  const auto regions = search_regions(settings.families);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const cases::Stratum& stratum = cases::all_strata()[regions[r].stratum];
    groups.push_back({std::string(word(stratum.family)), stratum.threshold, regions[r].origin_distance, {r}});
  }
  const auto pooled = pooled_groups(settings);
  groups.insert(groups.end(), pooled.begin(), pooled.end());
  return groups;
}

Onset sum(const Settings& settings, const Onsets& onsets, const RegionGroup& group, std::size_t method) {
  Onset sum;
  for (const std::size_t r : group.regions) sum += onsets.all[r * settings.methods.size() + method];
  return sum;
}

/// 2^-50.3, to which a share is rounded for people; nothing where there is none.
std::string power_of_two(double share) { return share > 0 ? fmt::format("2^{:.1f}", std::log2(share)) : "none seen"; }

}  // namespace

void write_onsets(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets) {
  std::string text = "family,threshold,origin_distance,method,test,exponent,wrong,samples,rate,lower,upper\n";
  for (const auto& group : region_groups(settings))
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const Onset onset = sum(settings, onsets, group, m);
      if (onset.samples == 0) continue;
      for (std::size_t k = 0; k <= kMostExponent; ++k) {
        const auto limits = statistics::clopper_pearson(onset.wrong[k], onset.samples);
        text += fmt::format("{},{},{:.0f},{},{},{},{},{},{:.6g},{:.6g},{:.6g}\n", group.family, word(group.threshold),
                            group.distance, settings.methods[m]->name(), test_word(group.threshold), k, onset.wrong[k],
                            onset.samples, static_cast<double>(onset.wrong[k]) / static_cast<double>(onset.samples),
                            limits.lower, limits.upper);
      }
    }
  harness::write_file(folder / "onset.csv", text);
}

void write_worst(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets,
                 const WorstCases& worst) {
  std::string table =
      "family,threshold,origin_distance,method,test,samples,sampled_share,climbed_share,climbed_doubles,climbed_from\n";
  std::string cases;
  const auto regions = search_regions(settings.families);
  for (std::size_t r = 0; r < regions.size(); ++r)
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const cases::Stratum& stratum = cases::all_strata()[regions[r].stratum];
      const Onset& onset = onsets.all[r * settings.methods.size() + m];
      const Worst& found = worst.all[r * settings.methods.size() + m];
      table += fmt::format("{},{},{:.0f},{},{},{},", word(stratum.family), word(stratum.threshold),
                           regions[r].origin_distance, settings.methods[m]->name(), test_word(stratum.threshold),
                           onset.samples);
      table += onset.furthest.empty() ? "," : fmt::format("{:.6g},", onset.furthest.front().share);
      table += found.share == 0 ? ",,\n" : fmt::format("{:.6g},{},{}\n", found.share, found.doubles, found.n);
      cases += found.line;
    }
  harness::write_file(folder / "worst.csv", table);
  harness::write_file(folder / "worst.jsonl", cases);
}

std::string search_table(const Settings& settings, const Onsets& onsets, const WorstCases& worst) {
  std::string text = fmt::format("{:<12} {:>9}  {:<16} {:>8}  {:<34} {:>12} {:>12}\n", "threshold", "distance",
                                 "method", "samples", "wrong from, and how often (95 %)", "furthest", "climbed");
  for (const auto& group : pooled_groups(settings))
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const Onset onset = sum(settings, onsets, group, m);
      if (onset.samples == 0) continue;
      std::string from = "at none";
      for (std::size_t k = kMostExponent + 1; k-- > 0;) {
        if (onset.wrong[k] == 0) continue;
        const auto limits = statistics::clopper_pearson(onset.wrong[k], onset.samples);
        from = fmt::format("2^-{}: {} to {} %", k, statistics::percent_to_places(limits.lower, 2),
                           statistics::percent_to_places(limits.upper, 2));
      }
      double climbed = 0;
      for (const std::size_t r : group.regions)
        climbed = std::max(climbed, worst.all[r * settings.methods.size() + m].share);
      text +=
          fmt::format("{:<12} {:>9.0f}  {:<16} {:>8}  {:<34} {:>12} {:>12}\n", word(group.threshold), group.distance,
                      settings.methods[m]->name(), onset.samples, from,
                      power_of_two(onset.furthest.empty() ? 0 : onset.furthest.front().share), power_of_two(climbed));
    }
  return text +
         "Offsets of the radius (foot-*: of a coordinate of the centre) from the threshold, as shares of the "
         "polygon's\n"
         "size, tested at the powers of two from 2^-60 to 1, and at 64 steps beyond the furthest wrong one. Rotated "
         "polygons;\n"
         "the truth is filtered, and exact for climbed cases. Distance from the origin, in sizes. Furthest: over all "
         "samples;\n"
         "climbed: after moving their coordinates.\n";
}

}  // namespace touchstone::near_edge
