// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdint>

#include "experiments/studies/near_edge/map.h"

namespace touchstone::near_edge {
namespace {

using OffsetRow = cases::OffsetRow<Failures>;

constexpr const char* kTestMeaning = "the decision that is compared";

const program::Table<OffsetRow>& rates_table() {
  static const program::Table<OffsetRow> table(
      "rates.csv", "a family, placement, threshold, test, method and offset",
      cases::offset_columns<OffsetRow>(
          kTestMeaning,
          {{"failures", "wrong or undecided answers", program::path(&OffsetRow::count, &Failures::not_right)},
           {"trials", "answers", program::path(&OffsetRow::count, &Failures::trials)}},
          "failures"));
  return table;
}

struct BandRow : cases::Subject {
  Failures samples, answers;
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
           {{"failures", "wrong or undecided answers at all offsets", path(&BandRow::answers, &Failures::not_right)},
            {"trials", "answers at all offsets", path(&BandRow::answers, &Failures::trials)}},
           cases::band_columns<BandRow>("the lowest offset at which a failure was seen")}));
  return table;
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

void write_failures(const std::filesystem::path& folder, const Settings& settings, const Counts& counts) {
  const auto groups = cases::stratum_groups(settings.families);
  std::vector<OffsetRow> rows;
  for (const auto& group : groups)
    for (const Test test : kTests)
      for (std::size_t m = 0; m < settings.methods.size(); ++m) {
        const TestFailures failures = sum(counts, group.strata, test, m);
        for (std::size_t i = 0; i < failures.offsets.size(); ++i)
          if (const Failures& at = failures.offsets[i]; at.trials > 0)
            rows.push_back({{&group, test, settings.methods[m]->name()},
                            cases::all_offsets()[i],
                            at,
                            program::rate(at.not_right(), at.trials)});
      }
  rates_table().write(folder, rows);
  bands_table().write(folder, band_rows(settings, groups, counts));
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
  const auto groups = cases::stratum_groups(settings.families);
  auto rows = band_rows(settings, groups, counts);
  std::erase_if(rows, [](const BandRow& row) {
    return row.group->family != "all" || row.test != cases::test_at(row.group->threshold);
  });
  return bands_table().aligned(rows) +
         "A sample is a polygon and a centre; it fails if the test is wrong, or left undecided, at any offset. Limits:\n"
         "Clopper-Pearson, 95 %. Offset: of the radius (foot-*: of one coordinate of the centre, with an ample radius), in\n"
         "doubles from the exact threshold; positive is larger (or: the foot is outside). bands.csv has the other tests.\n";
}

std::vector<program::TableDescription> tables() {
  return {rates_table().description(), bands_table().description(),
          map_table("map-<spot>-<test>-<distance>.csv", {"<method>"}).description()};
}

}  // namespace touchstone::near_edge
