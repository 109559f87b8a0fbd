// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "experiments/program/output.h"
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

/// Returns each region.
std::vector<RegionGroup> single_groups(const Settings& settings) {
  std::vector<RegionGroup> groups;
  const auto regions = search_regions(settings.families);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const cases::Stratum& stratum = cases::all_strata()[regions[r].stratum];
    groups.push_back({std::string(to_string(stratum.family)), stratum.threshold, regions[r].origin_distance, {r}});
  }
  return groups;
}

/// Returns the groups of all families.
std::vector<RegionGroup> pooled_groups(const Settings& settings) {
  std::vector<RegionGroup> groups;
  for (const cases::Threshold threshold : cases::all_thresholds())
    for (const double distance : kSearchDistances) {
      RegionGroup group{"all", threshold, distance, {}};
      for (const RegionGroup& single : single_groups(settings))
        if (single.threshold == threshold && single.distance == distance) group.regions.push_back(single.regions[0]);
      if (!group.regions.empty()) groups.push_back(std::move(group));
    }
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
std::vector<program::Column<Row>> subject_columns() {
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
  program::Rate rate;
};

const program::Table<OnsetRow>& onset_table() {
  static const program::Table<OnsetRow> table(
      "onset.csv", "a family, threshold, distance from the origin, method and exponent k",
      program::all_columns<OnsetRow>(
          {subject_columns<OnsetRow>(),
           {{"exponent", "k: the ball is 2^-k sizes from the threshold", &OnsetRow::exponent},
            {"wrong", "samples with a wrong answer on either side", &OnsetRow::wrong},
            {"samples", "samples", &OnsetRow::samples}},
           program::rate_columns<OnsetRow>("wrong samples", &OnsetRow::rate)}));
  return table;
}

struct WorstRow : Subject {
  std::uint64_t samples;
  std::optional<double> sampled, climbed;
};

const program::Table<WorstRow>& worst_table() {
  static const program::Table<WorstRow> table(
      "worst.csv", "a family, threshold, distance from the origin and method",
      program::all_columns<WorstRow>(
          {subject_columns<WorstRow>(),
           {{"samples", "random samples", &WorstRow::samples},
            {"sampled_share", "the furthest wrong offset of random samples, in sizes", &WorstRow::sampled, "{:.6g}"},
            {"climbed_share", "the furthest wrong offset after climbing, in sizes", &WorstRow::climbed, "{:.6g}"}}}));
  return table;
}

std::vector<WorstRow> worst_rows(const Settings& settings, const std::vector<RegionGroup>& groups, const Onsets& onsets,
                                 const WorstCases& worst) {
  std::vector<WorstRow> rows;
  for (const RegionGroup& group : groups)
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const Onset onset = sum(settings, onsets, group, m);
      double climbed = 0;
      for (const std::size_t r : group.regions)
        climbed = std::max(climbed, worst.all[r * settings.methods.size() + m].share);
      rows.push_back({{&group, settings.methods[m]->name()},
                      onset.samples,
                      onset.furthest.empty() ? std::nullopt : std::optional(onset.furthest.front().share),
                      climbed == 0 ? std::nullopt : std::optional(climbed)});
    }
  return rows;
}

}  // namespace

void write_onsets(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets) {
  auto groups = single_groups(settings);
  const auto pooled = pooled_groups(settings);
  groups.insert(groups.end(), pooled.begin(), pooled.end());
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
                        program::rate(onset.wrong[k], onset.samples)});
    }
  onset_table().write(folder, rows);
}

void write_worst(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets,
                 const WorstCases& worst) {
  const auto groups = single_groups(settings);
  worst_table().write(folder, worst_rows(settings, groups, onsets, worst));
  std::string cases;
  for (const Worst& found : worst.all) cases += found.line;
  program::write_file(folder / "worst.jsonl", cases);
}

std::vector<program::TableDescription> search_tables() {
  return {onset_table().description(), worst_table().description()};
}

std::string search_table(const Settings& settings, const Onsets& onsets, const WorstCases& worst) {
  const auto groups = pooled_groups(settings);
  return worst_table().aligned(worst_rows(settings, groups, onsets, worst)) +
         "Offsets of the radius (foot-*: of a coordinate of the centre) from the threshold at which a method is wrong, of "
         "rotated\npolygons. Random samples are tested at the powers of two from 2^-60 to 1, and at 64 steps beyond the "
         "furthest wrong one;\nthe search then moves their coordinates. onset.csv says how often.\n";
}

}  // namespace touchstone::near_edge
