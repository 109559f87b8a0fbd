// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdint>

#include "experiments/run/output.h"
#include "experiments/run/statistics/shares.h"
#include "experiments/studies/near_edge/map.h"

namespace touchstone::near_edge {
namespace {

using OffsetRow = cases::OffsetRow<Failures>;

constexpr const char* kTestMeaning = "the decision that is compared";

const run::Table<OffsetRow>& rates_table() {
  static const run::Table<OffsetRow> table(
      "rates.csv", "a family, placement, threshold, test, method and offset",
      cases::offset_columns<OffsetRow>(
          kTestMeaning,
          {{"failures", "wrong or undecided answers", run::path(&OffsetRow::count, &Failures::not_right)},
           {"trials", "answers", run::path(&OffsetRow::count, &Failures::trials)}},
          "failures"));
  return table;
}

struct BandRow : cases::Subject {
  Failures samples, answers;
  cases::Band band;
  run::Rate rate;
};

const run::Table<BandRow>& bands_table() {
  using run::path;
  static const run::Table<BandRow> table(
      "bands.csv", "a family, placement, threshold, test and method",
      run::all_columns<BandRow>(
          {cases::subject_columns<BandRow>(kTestMeaning),
           {{"failed_samples", "samples that failed at any offset", path(&BandRow::samples, &Failures::wrong)},
            {"samples", "samples", path(&BandRow::samples, &Failures::trials)}},
           run::rate_columns<BandRow>("failed samples", &BandRow::rate),
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
run::Table<PixelRow> map_table(const std::string& file, const std::vector<std::string>& methods) {
  std::vector<run::Column<PixelRow>> columns{
      {"row", "the row of the pixel, from the top", [](const PixelRow& row) { return row.pixel / Map::kSize; }},
      {"column", "its column", [](const PixelRow& row) { return row.pixel % Map::kSize; }},
      {"truth", "i(nside), b(oundary), o(utside), or c(ontact), n(one)",
       [](const PixelRow& row) { return std::string(1, row.map->truth[row.pixel]); }}};
  for (std::size_t m = 0; m < methods.size(); ++m)
    columns.emplace_back(methods[m], "= right, + wrongly in, - wrongly out, b boundary missed",
                         [m](const PixelRow& row) { return std::string(1, row.map->verdicts[m][row.pixel]); });
  return {file, "a pixel", columns};
}

std::vector<std::size_t> strata_of(cases::Threshold threshold) {
  std::vector<std::size_t> strata;
  for (std::size_t s = 0; s < cases::all_strata().size(); ++s)
    if (cases::all_strata()[s].threshold == threshold) strata.push_back(s);
  return strata;
}

cases::Band band_of(const TestFailures& failures) { return cases::band_of(failures.offsets, &Failures::not_right); }

std::string_view movement(cases::Threshold threshold) {
  switch (threshold) {
    case cases::Threshold::Face: return "radius across the distance to a face";
    case cases::Threshold::Edge: return "radius across the distance to an edge";
    case cases::Threshold::Vertex: return "radius across the distance to a vertex";
    case cases::Threshold::Tangent: return "radius across a distance that is a double (lattice)";
    case cases::Threshold::FootEdge: return "centre moved so that its foot crosses an edge; ample radius";
    case cases::Threshold::FootVertex: return "centre moved so that its foot passes a vertex; ample radius";
  }
  return "";
}

constexpr std::string_view kLegend =
    "A sample is a polygon and a centre; it fails if the test is wrong, or left undecided, at any offset.\n"
    "Limits: Clopper-Pearson, 95 %.\n"
    "Offset: of the radius (or of one coordinate of the centre), in doubles from the exact threshold; positive is\n"
    "larger (or: the foot is outside). Band: the lowest and the highest offset at which a failure was seen.\n"
    "plane: intersects or not (front and behind count alike). foot: inside, boundary or outside; for a method without\n"
    "the word boundary, either is right on a boundary. edges: the whole list. contact: the final answer.\n";

}  // namespace

void write_rates(const std::filesystem::path& folder, const Settings& settings, const Counts& counts) {
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
                            run::rate(at.not_right(), at.trials)});
      }
  rates_table().write(folder, rows);
}

void write_bands(const std::filesystem::path& folder, const Settings& settings, const Counts& counts) {
  const auto groups = cases::stratum_groups(settings.families);
  std::vector<BandRow> rows;
  for (const auto& group : groups)
    for (const Test test : kTests)
      for (std::size_t m = 0; m < settings.methods.size(); ++m) {
        const TestFailures failures = sum(counts, group.strata, test, m);
        if (failures.samples.trials > 0)
          rows.push_back({{&group, test, settings.methods[m]->name()},
                          failures.samples,
                          cases::total(failures.offsets),
                          band_of(failures),
                          failures.samples.rate()});
      }
  bands_table().write(folder, rows);
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
  std::string text;
  for (const cases::Threshold threshold : cases::all_thresholds()) {
    text +=
        fmt::format("\n{}: {}\n  {:<16} {:<8} {:>18}  {:>8}  {:<22} {}\n", to_string(threshold), movement(threshold),
                    "method", "test", "failed of samples", "rate", "95 % limits", "band of offsets");
    for (std::size_t m = 0; m < settings.methods.size(); ++m)
      for (const Test test : kTests) {
        const TestFailures failures = sum(counts, strata_of(threshold), test, m);
        if (failures.samples.trials == 0) continue;
        const run::Rate rate = failures.samples.rate();
        text += fmt::format("  {:<16} {:<8} {:>18}  {:>7}%  {:<22} {}\n", settings.methods[m]->name(), to_string(test),
                            fmt::format("{} of {}", failures.samples.wrong, failures.samples.trials),
                            statistics::percent_to_places(rate.share, 3),
                            fmt::format("{} to {} %", statistics::percent_to_places(rate.lower, 3),
                                        statistics::percent_to_places(rate.upper, 3)),
                            to_string(band_of(failures)));
      }
  }
  return text.append("\n").append(kLegend);
}

std::vector<run::TableDescription> tables() {
  return {rates_table().description(), bands_table().description(),
          map_table("map-<spot>-<test>-<distance>.csv", {"<method>"}).description()};
}

}  // namespace touchstone::near_edge
