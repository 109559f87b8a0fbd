// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/soak/output.h"

#include <fmt/core.h>

#include "experiments/harness/write_file.h"
#include "experiments/statistics/clopper_pearson.h"

namespace touchstone::soak {
namespace {

/// Calls row(family, way, outcomes) for each that was asked about, then for the sums of each way.
template <class Row>
void for_each_row(const Tally& tally, const Row& row) {
  for (const Way way : kWays) {
    Outcomes all;
    for (const adversarial::Family family : adversarial::all_families()) {
      const Outcomes& outcomes = tally.at(family, way);
      if (outcomes.cases > 0) row(word(family), word(way), outcomes);
      all += outcomes;
    }
    if (all.cases > 0) row("all", word(way), all);
  }
}

std::string stage_words(const char* form) {
  std::string text;
  for (std::size_t stage = 0; stage < filtered::kStages; ++stage)
    text += fmt::format(fmt::runtime(form), word(static_cast<filtered::Stage>(stage)));
  return text;
}

std::string verdict(const Tally& tally) {
  const auto limits = statistics::clopper_pearson(tally.differing(), tally.cases());
  if (tally.differing() == 0)
    return fmt::format("No difference from exact in {} cases: at most {:.3g} of such cases differ (95 %).\n",
                       tally.cases(), limits.upper);
  return fmt::format("{} of {} cases DIFFER from exact: {:.3g} to {:.3g} of such cases (95 %).\n", tally.differing(),
                     tally.cases(), limits.lower, limits.upper);
}

}  // namespace

void write_counts(const std::filesystem::path& folder, const Tally& tally) {
  std::string text = "family,way,cases" + stage_words(",{}") + ",differences\n";
  for_each_row(tally, [&](std::string_view family, std::string_view way, const Outcomes& outcomes) {
    text += fmt::format("{},{},{}", family, way, outcomes.cases);
    for (const std::uint64_t count : outcomes.by_stage) text += fmt::format(",{}", count);
    text += fmt::format(",{}\n", outcomes.differences);
  });
  harness::write_file(folder / "soak.csv", text);
}

void write_differences(const std::filesystem::path& folder, const Tally& tally) {
  std::string text;
  for (const Difference& difference : tally.kept()) text += difference.line;
  harness::write_file(folder / "differences.jsonl", text);
}

std::string table(const Tally& tally) {
  std::string text =
      fmt::format("{:<9} {:<10} {:>11}{} {:>11}\n", "asked", "family", "cases", stage_words(" {:>13}"), "differences");
  for_each_row(tally, [&](std::string_view family, std::string_view way, const Outcomes& outcomes) {
    text += fmt::format("{:<9} {:<10} {:>11}", way, family, outcomes.cases);
    for (const std::uint64_t count : outcomes.by_stage) text += fmt::format(" {:>13}", count);
    text += fmt::format(" {:>11}\n", outcomes.differences);
  });
  return text + "Stages: the slowest that a case reached.\n" + verdict(tally);
}

}  // namespace touchstone::soak
