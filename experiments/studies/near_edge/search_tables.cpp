// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "experiments/run/output.h"
#include "experiments/run/statistics/shares.h"
#include "experiments/studies/near_edge/search.h"

namespace touchstone::near_edge {
namespace {

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

std::vector<RegionGroup> single_groups(const Settings& settings) {
  std::vector<RegionGroup> groups;
  const auto regions = search_regions(settings.families);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const cases::Stratum& stratum = cases::all_strata()[regions[r].stratum];
    groups.push_back({std::string(to_string(stratum.family)), stratum.threshold, regions[r].origin_distance, {r}});
  }
  return groups;
}

std::vector<RegionGroup> region_groups(const Settings& settings) {
  auto groups = single_groups(settings);
  const auto pooled = pooled_groups(settings);
  groups.insert(groups.end(), pooled.begin(), pooled.end());
  return groups;
}

Onset sum(const Settings& settings, const Onsets& onsets, const RegionGroup& group, std::size_t method) {
  Onset sum;
  for (const std::size_t r : group.regions) sum += onsets.all[r * settings.methods.size() + method];
  return sum;
}

/// What the rows of both tables are about: regions, and a method.
struct Subject {
  const RegionGroup* group;
  std::string_view method;
};

/// The columns with which the rows of both tables begin.
template <class Row>
std::vector<run::Column<Row>> subject_columns() {
  return {
      {"family", "the family of polygons, or `all`", [](const Row& row) { return row.group->family; }},
      {"threshold", "the threshold that balls cross", [](const Row& row) { return row.group->threshold; }},
      {"origin_distance", "of the polygon from the origin, in multiples of its size",
       [](const Row& row) { return row.group->distance; }, "{:.0f}"},
      {"method", "the method", &Row::method},
      {"test", "the decision that is compared", [](const Row& row) { return cases::test_at(row.group->threshold); }}};
}

struct OnsetRow : Subject {
  std::size_t exponent;
  std::uint64_t wrong, samples;
  run::Rate rate;
};

const run::Table<OnsetRow>& onset_table() {
  static const run::Table<OnsetRow> table(
      "onset.csv", "a family, threshold, distance from the origin, method and exponent k",
      run::all_columns<OnsetRow>({subject_columns<OnsetRow>(),
                                  {{"exponent", "k: the ball is 2^-k sizes from the threshold", &OnsetRow::exponent},
                                   {"wrong", "samples with a wrong answer on either side", &OnsetRow::wrong},
                                   {"samples", "samples", &OnsetRow::samples}},
                                  run::rate_columns<OnsetRow>("wrong samples", &OnsetRow::rate)}));
  return table;
}

struct WorstRow : Subject {
  const Onset* onset;
  const Worst* worst;
};

const run::Table<WorstRow>& worst_table() {
  static const run::Table<WorstRow> table(
      "worst.csv", "a family, threshold, distance from the origin and method",
      run::all_columns<WorstRow>(
          {subject_columns<WorstRow>(),
           {{"samples", "random samples", [](const WorstRow& row) { return row.onset->samples; }},
            {"sampled_share", "the furthest wrong offset of random samples, in sizes",
             [](const WorstRow& row) {
               const auto& furthest = row.onset->furthest;
               return furthest.empty() ? std::nullopt : std::optional(furthest.front().share);
             },
             "{:.6g}"},
            {"climbed_share", "the furthest wrong offset after climbing, in sizes",
             [](const WorstRow& row) { return row.worst->share != 0 ? std::optional(row.worst->share) : std::nullopt; },
             "{:.6g}"}}}));
  return table;
}

/// 2^-50.3, to which a share is rounded for people; nothing without a share.
std::string power_of_two(double share) { return share > 0 ? fmt::format("2^{:.1f}", std::log2(share)) : "none seen"; }

}  // namespace

void write_onsets(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets) {
  const auto groups = region_groups(settings);
  std::vector<OnsetRow> rows;
  for (const auto& group : groups)
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const Onset onset = sum(settings, onsets, group, m);
      if (onset.samples == 0) continue;
      for (std::size_t k = 0; k <= kMostExponent; ++k)
        rows.push_back({{&group, settings.methods[m]->name()},
                        k,
                        onset.wrong[k],
                        onset.samples,
                        run::rate(onset.wrong[k], onset.samples)});
    }
  onset_table().write(folder, rows);
}

void write_worst(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets,
                 const WorstCases& worst) {
  const auto groups = single_groups(settings);
  std::vector<WorstRow> rows;
  std::string cases;
  for (std::size_t r = 0; r < groups.size(); ++r)
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const std::size_t at = r * settings.methods.size() + m;
      rows.push_back({{&groups[r], settings.methods[m]->name()}, &onsets.all[at], &worst.all[at]});
      cases += worst.all[at].line;
    }
  worst_table().write(folder, rows);
  run::write_file(folder / "worst.jsonl", cases);
}

std::vector<run::TableDescription> search_tables() {
  return {onset_table().description(), worst_table().description()};
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
          fmt::format("{:<12} {:>9.0f}  {:<16} {:>8}  {:<34} {:>12} {:>12}\n", to_string(group.threshold),
                      group.distance, settings.methods[m]->name(), onset.samples, from,
                      power_of_two(onset.furthest.empty() ? 0 : onset.furthest.front().share), power_of_two(climbed));
    }
  return text +
         "Offsets of the radius (foot-*: of a coordinate of the centre) from the threshold, as shares "
         "of the polygon's\n"
         "size, tested at the powers of two from 2^-60 to 1, and at 64 steps beyond the furthest wrong one. "
         "Rotated polygons;\n"
         "the truth is filtered, and exact for climbed cases. Distance from the origin, in sizes. Furthest: "
         "over all samples;\n"
         "climbed: after moving their coordinates.\n";
}

}  // namespace touchstone::near_edge
