// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "experiments/program/output.h"
#include "experiments/program/printing.h"
#include "experiments/program/statistics/shares.h"
#include "experiments/program/table.h"
#include "experiments/studies/soak/measure.h"

namespace touchstone::soak {
namespace {

struct Row {
  std::string_view family, way;
  Outcomes outcomes;
};

/// Returns the rows of each family and way that was asked about, and of all families of each way.
std::vector<Row> rows_of(const Tally& tally) {
  std::vector<Row> rows;
  for (const Way way : kWays) {
    Outcomes all;
    for (const workloads::adversarial::Family family : workloads::adversarial::all_families()) {
      const Outcomes& outcomes = tally.at(family, way);
      if (outcomes.cases > 0) rows.push_back({to_string(family), to_string(way), outcomes});
      program::add(all, outcomes);
    }
    if (all.cases > 0) rows.push_back({"all", to_string(way), all});
  }
  return rows;
}

program::Table<Row> counts_table() {
  std::vector<program::Column<Row>> columns{{"family", "the family of cases, or `all`", &Row::family},
                                            {"way", "how the question was asked", &Row::way},
                                            {"cases", "cases", program::path(&Row::outcomes, &Outcomes::cases)}};
  for (std::size_t stage = 0; stage < filtered::kStages; ++stage)
    columns.emplace_back(std::string(to_string(static_cast<filtered::Stage>(stage))),
                         "cases of which this was the slowest stage",
                         [stage](const Row& row) { return row.outcomes.by_stage[stage]; });
  columns.emplace_back("differences", "cases that differed from exact",
                       program::path(&Row::outcomes, &Outcomes::differences));
  return {"soak.csv", "a family of cases and a way of asking", columns};
}

std::string verdict(const Tally& tally) {
  const auto limits = statistics::clopper_pearson(tally.differing(), tally.cases());
  if (tally.differing() == 0)
    return fmt::format("No difference from exact in {}: at most {:.3g} of such cases differ (95 %).\n",
                       program::counted(tally.cases(), "case"), limits.upper);
  return fmt::format("{} of {} DIFFER from exact: {:.3g} to {:.3g} of such cases (95 %).\n", tally.differing(),
                     program::counted(tally.cases(), "case"), limits.lower, limits.upper);
}

}  // namespace

void write_counts(const std::filesystem::path& folder, const Tally& tally) {
  counts_table().write(folder, rows_of(tally));
}

std::vector<program::TableDescription> tables() { return {counts_table().description()}; }

void write_differences(const std::filesystem::path& folder, const Tally& tally) {
  std::string text;
  for (const Difference& difference : tally.kept()) text += difference.line;
  program::write_file(folder / "differences.jsonl", text);
}

std::string table(const Tally& tally) {
  return counts_table().aligned(rows_of(tally)) + "Stages: the slowest that a case reached.\n" + verdict(tally);
}

}  // namespace touchstone::soak
