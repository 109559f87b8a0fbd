// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdint>

#include "experiments/studies/near_edge/map.h"

namespace touchstone::near_edge {
namespace {

using cases::Threshold;
using OffsetRow = cases::OffsetRow<CrossingFailures>;

constexpr const char* kTestMeaning = "the decision that is compared";
constexpr const char* kFailures =
    "wrong or undecided answers about the polygon as given, or by the contract if the method lifts vertices";

const program::Table<OffsetRow>& rates_table() {
  static const program::Table<OffsetRow> table(
      "rates.csv", "a family, placement, threshold, test, method and offset",
      cases::offset_columns<OffsetRow>(kTestMeaning,
                                       {{"failures", kFailures, program::path(&OffsetRow::count, &Failures::not_right)},
                                        {"trials", "answers", program::path(&OffsetRow::count, &Failures::trials)},
                                        {"contract", "answers wrong or undecided by the contract, which lifts vertices",
                                         program::path(&OffsetRow::count, &CrossingFailures::contract)},
                                        {"lift", "of these, answers right about the polygon as given",
                                         program::path(&OffsetRow::count, &CrossingFailures::lift)}},
                                       "failures"));
  return table;
}

struct BandRow : cases::Subject {
  Failures samples;
  CrossingFailures answers;
  cases::Band band;
  program::Rate rate;
};

const program::Table<BandRow>& bands_table() {
  using program::path;
  static const program::Table<BandRow> table(
      "bands.csv", "a family, placement, threshold, test and method",
      program::all_columns<BandRow>(
          {cases::subject_columns<BandRow>(kTestMeaning),
           {{"failed_samples", "samples that failed at any offset", path(&BandRow::samples, &Failures::wrong)},
            {"samples", "samples", path(&BandRow::samples, &Failures::trials)}},
           program::rate_columns<BandRow>("failed samples", &BandRow::rate),
           {{"failures", "failures at all offsets", path(&BandRow::answers, &Failures::not_right)},
            {"trials", "answers at all offsets", path(&BandRow::answers, &Failures::trials)},
            {"contract", "answers wrong or undecided by the contract",
             path(&BandRow::answers, &CrossingFailures::contract)},
            {"lift", "of these, answers right about the polygon as given",
             path(&BandRow::answers, &CrossingFailures::lift)}},
           cases::band_columns<BandRow>("the lowest offset at which a failure was seen")}));
  return table;
}

/// The answers at one offset, at one range of a property.
struct PropertyRow {
  Property property;
  double from, to;
  Threshold threshold;
  std::string_view method;
  double offset;
  CrossingFailures count;
  program::Rate rate;
};

const program::Table<PropertyRow>& properties_table() {
  using program::path;
  static const program::Table<PropertyRow> table(
      "properties.csv", "a range of a property of exactly planar loops, a threshold, method and offset",
      program::all_columns<PropertyRow>(
          {{{"property", "the property", &PropertyRow::property},
            {"from", "the end of the range before", &PropertyRow::from},
            {"to", "the end of the range; beyond the last one too", &PropertyRow::to},
            {"threshold", "the threshold that balls cross", &PropertyRow::threshold},
            {"method", "the method", &PropertyRow::method},
            {"offset", "the distance of the ball from the threshold, in u x size", &PropertyRow::offset},
            {"failures", kFailures, path(&PropertyRow::count, &Failures::not_right)},
            {"trials", "answers to `contact`", path(&PropertyRow::count, &Failures::trials)}},
           program::rate_columns<PropertyRow>("failures", &PropertyRow::rate)}));
  return table;
}

std::vector<PropertyRow> property_rows(const Settings& settings, const ByProperty& counts) {
  std::vector<PropertyRow> rows;
  for (std::size_t p = 0; p < kProperties.size(); ++p)
    for (const Threshold threshold : cases::all_thresholds())
      for (std::size_t range = 0; range < ends(kProperties[p]).size(); ++range)
        for (std::size_t m = 0; m < settings.methods.size(); ++m)
          for (std::size_t i = 0; i < cases::all_offsets().size(); ++i) {
            const CrossingFailures& at = counts[static_cast<std::size_t>(threshold)][p][range].offsets[m][i];
            if (at.trials == 0) continue;
            rows.push_back({kProperties[p], range == 0 ? 0 : ends(kProperties[p])[range - 1],
                            ends(kProperties[p])[range], threshold, settings.methods[m]->name(),
                            cases::all_offsets()[i], at, program::rate(at.not_right(), at.trials)});
          }
  return rows;
}

/// A pixel of a map.
struct PixelRow {
  const Map* map;
  std::size_t pixel;
};

/// The table of the maps with one column for each method.
program::Table<PixelRow> map_table(const std::string& file, const std::vector<std::string>& methods) {
  std::vector<program::Column<PixelRow>> columns{
      {"row", "the row of the pixel, from the top", [](const PixelRow& row) { return row.pixel / Map::kSize; }},
      {"column", "its column", [](const PixelRow& row) { return row.pixel % Map::kSize; }},
      {"truth", "i(nside), b(oundary), o(utside), or c(ontact), n(one)",
       [](const PixelRow& row) { return std::string(1, row.map->truth[row.pixel]); }}};
  for (std::size_t m = 0; m < methods.size(); ++m)
    columns.emplace_back(methods[m], "= right, + wrongly in, - wrongly out, b boundary missed",
                         [m](const PixelRow& row) { return std::string(1, row.map->verdicts[m][row.pixel]); });
  return {file, "a pixel", columns};
}

std::vector<BandRow> band_rows(const Settings& settings, const std::vector<cases::StratumGroup>& groups,
                               const Counts& counts) {
  std::vector<BandRow> rows;
  for (const auto& group : groups)
    for (const Test test : kTests)
      for (std::size_t m = 0; m < settings.methods.size(); ++m) {
        const TestFailures failures = sum(counts, group.strata, test, m);
        if (failures.samples.trials > 0)
          rows.push_back({{&group, test, settings.methods[m]->name()},
                          failures.samples,
                          cases::total(failures.offsets),
                          cases::band_of(failures.offsets, &Failures::not_right),
                          failures.samples.rate()});
      }
  return rows;
}

}  // namespace

void write_failures(const std::filesystem::path& folder, const Settings& settings, const Result& result) {
  const auto groups = cases::stratum_groups(settings);
  std::vector<OffsetRow> rows;
  for (const auto& group : groups)
    for (const Test test : kTests)
      for (std::size_t m = 0; m < settings.methods.size(); ++m) {
        const TestFailures failures = sum(result.counts, group.strata, test, m);
        for (std::size_t i = 0; i < failures.offsets.size(); ++i)
          if (const CrossingFailures& at = failures.offsets[i]; at.trials > 0)
            rows.push_back({{&group, test, settings.methods[m]->name()},
                            cases::all_offsets()[i],
                            at,
                            program::rate(at.not_right(), at.trials)});
      }
  rates_table().write(folder, rows);
  bands_table().write(folder, band_rows(settings, groups, result.counts));
  properties_table().write(folder, property_rows(settings, result.by_property));
}

void write_maps(const std::filesystem::path& folder, const Settings& settings, const std::vector<Map>& maps) {
  std::vector<std::string> methods;
  for (const auto* method : settings.methods) methods.emplace_back(method->name());
  for (const Map& map : maps) {
    std::vector<PixelRow> rows;
    for (std::size_t pixel = 0; pixel < map.truth.size(); ++pixel) rows.push_back({&map, pixel});
    const auto file =
        fmt::format("map-{}-{}-{:.0f}.csv", to_string(map.spot), to_string(map.test), map.origin_distance);
    map_table(file, methods).write(folder, rows);
  }
}

std::string table(const Settings& settings, const Counts& counts) {
  const auto groups = cases::stratum_groups(settings);
  auto rows = band_rows(settings, groups, counts);
  std::erase_if(rows, [](const BandRow& row) {
    return row.group->family != "all" || row.test != cases::test_at(row.group->threshold);
  });
  return bands_table().aligned(rows) +
         "A sample is a polygon and a centre; it fails if the test is wrong, or left undecided, at any offset, about the\n"
         "polygon as given, or by the contract if the method lifts vertices. Limits: Clopper-Pearson, 95 %. Offset: of the\n"
         "radius (foot-*: of one coordinate of the centre, with an ample radius) from the exact threshold, in u x size, where\n"
         "u is 2^-53 and the size is the polygon's extent; positive is larger (or: the foot is outside). bands.csv has the\n"
         "other tests.\n";
}

std::vector<program::TableDescription> tables() {
  return {rates_table().description(), bands_table().description(), properties_table().description(),
          map_table("map-<spot>-<test>-<distance>.csv", {"<method>"}).description()};
}

}  // namespace touchstone::near_edge
