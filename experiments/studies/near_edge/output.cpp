// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/harness/write_file.h"
#include "experiments/statistics/clopper_pearson.h"
#include "experiments/statistics/percent.h"

namespace touchstone::near_edge {
namespace {

double rate(const Tally& tally) {
  return tally.trials == 0 ? 0 : static_cast<double>(tally.failures) / static_cast<double>(tally.trials);
}

/// The subject of a line in the tables: one stratum, or those of all families.
struct Group {
  std::string name;
  std::vector<std::size_t> strata;
};

std::vector<Group> all_groups() {
  std::vector<Group> single, pooled;
  for (std::size_t s = 0; s < cases::all_strata().size(); ++s) {
    const auto& [family, placement, threshold] = cases::all_strata()[s];
    const std::string where = fmt::format("{},{}", word(placement), word(threshold));
    single.push_back({fmt::format("{},{}", word(family), where), {s}});
    const std::string all = "all," + where;
    auto group = std::find_if(pooled.begin(), pooled.end(), [&](const Group& other) { return other.name == all; });
    if (group == pooled.end()) group = pooled.insert(group, {all, {}});
    group->strata.push_back(s);
  }
  single.insert(single.end(), pooled.begin(), pooled.end());
  return single;
}

std::vector<std::size_t> strata_of(cases::Threshold threshold) {
  std::vector<std::size_t> strata;
  for (std::size_t s = 0; s < cases::all_strata().size(); ++s)
    if (cases::all_strata()[s].threshold == threshold) strata.push_back(s);
  return strata;
}

/// Three columns of a table.
std::string rate_and_limits(const Tally& tally) {
  const auto limits = statistics::clopper_pearson(tally.failures, tally.trials);
  return fmt::format("{:.6g},{:.6g},{:.6g}", rate(tally), limits.lower, limits.upper);
}

/// An offset as people read it; the ends of the sweep hide what lies beyond.
std::string offset_text(std::int64_t offset) {
  const std::int64_t size = std::abs(offset);
  std::string text = offset < 0 ? "-" : "+";
  if (offset == 0) return "0";
  int exponent = 0;
  while ((std::int64_t{1} << exponent) < size) ++exponent;
  text += size <= 1024 ? std::to_string(size) : "2^" + std::to_string(exponent);
  return size == cases::all_offsets().back() ? text + " or beyond" : text;
}

std::string band_text(const Summary& summary) {
  if (!summary.below) return "none seen";
  const bool single = summary.below == summary.above;
  return single ? offset_text(*summary.below) : offset_text(*summary.below) + " to " + offset_text(*summary.above);
}

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
  std::string text = "family,placement,threshold,test,method,offset,failures,trials,rate,lower,upper\n";
  for (const Group& group : all_groups())
    for (const Test test : kTests)
      for (std::size_t m = 0; m < settings.methods.size(); ++m)
        for (std::size_t i = 0; i < cases::all_offsets().size(); ++i) {
          Tally tally;
          for (const std::size_t stratum : group.strata) tally += counts.at(stratum, test, m, i);
          if (tally.trials == 0) continue;
          text += fmt::format("{},{},{},{},{},{},{}\n", group.name, word(test), settings.methods[m]->name(),
                              cases::all_offsets()[i], tally.failures, tally.trials, rate_and_limits(tally));
        }
  harness::write_file(folder / "rates.csv", text);
}

void write_bands(const std::filesystem::path& folder, const Settings& settings, const Counts& counts) {
  std::string text =
      "family,placement,threshold,test,method,failed_samples,samples,rate,lower,upper,failures,trials,lowest_offset,"
      "highest_offset\n";
  for (const Group& group : all_groups())
    for (const Test test : kTests)
      for (std::size_t m = 0; m < settings.methods.size(); ++m) {
        const auto& [samples, all, below, above] = counts.summary(group.strata, test, m);
        if (samples.trials == 0) continue;
        text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", group.name, word(test), settings.methods[m]->name(),
                            samples.failures, samples.trials, rate_and_limits(samples), all.failures, all.trials,
                            below ? std::to_string(*below) : "", above ? std::to_string(*above) : "");
      }
  harness::write_file(folder / "bands.csv", text);
}

void write_disagreements(const std::filesystem::path& folder, const Result& result) {
  std::string text;
  for (const Disagreement& disagreement : result.disagreements.kept()) text += disagreement.line;
  harness::write_file(folder / "disagreements.jsonl", text);
}

void write_maps(const std::filesystem::path& folder, const Settings& settings, const std::vector<Map>& maps) {
  for (const Map& map : maps) {
    std::string text = "row,column,truth";
    for (const auto* method : settings.methods) text.append(",").append(method->name());
    text += "\n";
    for (std::size_t pixel = 0; pixel < map.truth.size(); ++pixel) {
      text += fmt::format("{},{},{}", pixel / Map::kSize, pixel % Map::kSize, map.truth[pixel]);
      for (const std::string& verdicts : map.verdicts) text.append(",").append(1, verdicts[pixel]);
      text += "\n";
    }
    const auto name = fmt::format("map-{}-{}-{:.0f}.csv", word(map.spot), word(map.test), map.origin_distance);
    harness::write_file(folder / name, text);
  }
}

std::string table(const Settings& settings, const Counts& counts) {
  std::string text;
  for (const cases::Threshold threshold : cases::all_thresholds()) {
    text += fmt::format("\n{}: {}\n  {:<16} {:<8} {:>18}  {:>8}  {:<22} {}\n", word(threshold), movement(threshold),
                        "method", "test", "failed of samples", "rate", "95 % limits", "band of offsets");
    for (std::size_t m = 0; m < settings.methods.size(); ++m)
      for (const Test test : kTests) {
        const Summary summary = counts.summary(strata_of(threshold), test, m);
        const auto& [failures, trials] = summary.samples;
        if (trials == 0) continue;
        const auto limits = statistics::clopper_pearson(failures, trials);
        text += fmt::format("  {:<16} {:<8} {:>18}  {:>7}%  {:<22} {}\n", settings.methods[m]->name(), word(test),
                            fmt::format("{} of {}", failures, trials),
                            statistics::percent_to_places(rate(summary.samples), 3),
                            fmt::format("{} to {} %", statistics::percent_to_places(limits.lower, 3),
                                        statistics::percent_to_places(limits.upper, 3)),
                            band_text(summary));
      }
  }
  return text.append("\n").append(kLegend);
}

}  // namespace touchstone::near_edge
