// SPDX-License-Identifier: GPL-3.0-or-later
#include <iterator>
#include <string_view>

#include "experiments/studies/stability/output.h"

namespace touchstone::stability {
namespace {

using run::path;

struct OnsetRow {
  double distance;
  std::string_view method;
  int exponent;
  std::uint64_t failed, triangles, wrong;
  run::Rate rate;
};

const run::Table<OnsetRow>& onset_table() {
  static const run::Table<OnsetRow> table(
      "onset.csv", "a distance from the origin, method and offset",
      run::all_columns<OnsetRow>(
          {{{"origin_distance", "of the triangle, in multiples of its size", &OnsetRow::distance},
            {"method", "the method", &OnsetRow::method},
            {"offset_exponent", "of the radius: 2^this of the exact distance", &OnsetRow::exponent},
            {"failed_triangles", "triangles with a wrong answer", &OnsetRow::failed},
            {"triangles", "triangles", &OnsetRow::triangles}},
           run::rate_columns<OnsetRow>("failed triangles", &OnsetRow::rate),
           {{"wrong_answers", "wrong answers", &OnsetRow::wrong},
            {"answers", "answers, two for each triangle", [](const OnsetRow& row) { return 2 * row.triangles; }}}}));
  return table;
}

struct ContractionRow {
  ContractionCount count;
  run::Rate plain, fused;
};

const run::Table<ContractionRow>& contraction_table() {
  using Row = ContractionRow;
  static const run::Table<Row> table(
      "contraction.csv", "a sign and a family of exact values",
      run::all_columns<Row>(
          {{{"sign", "the expression whose sign is computed", path(&Row::count, &ContractionCount::sign)},
            {"family", "its exact value", path(&Row::count, &ContractionCount::family)},
            {"trials", "trials", path(&Row::count, &ContractionCount::trials)},
            {"plain_wrong", "wrong signs without contraction", path(&Row::count, &ContractionCount::plain_wrong)}},
           run::rate_columns<Row>("wrong signs without contraction", &Row::plain, "plain_"),
           {{"fused_wrong", "wrong signs with fused multiply-adds", path(&Row::count, &ContractionCount::fused_wrong)}},
           run::rate_columns<Row>("wrong signs with fused multiply-adds", &Row::fused, "fused_"),
           {{"signs_differ", "trials in which the two differ", path(&Row::count, &ContractionCount::differ)}}}));
  return table;
}

}  // namespace

void write_known(const std::filesystem::path& folder, const Known& known) {
  const Onset& onset = known.onset;
  std::vector<OnsetRow> onsets;
  for (std::size_t d = 0; d < std::size(kOnsetDistances); ++d)
    for (std::size_t m = 0; m < onset.methods().size(); ++m)
      for (int k = kCoarsest; k <= kFinest; ++k)
        onsets.push_back({kOnsetDistances[d], onset.methods()[m], -k, onset.failures(d, m, k), onset.triangles(),
                          onset.wrong(d, m, k), run::rate(onset.failures(d, m, k), onset.triangles())});
  onset_table().write(folder, onsets);

  std::vector<ContractionRow> contractions;
  for (const ContractionCount& c : known.contractions)
    contractions.push_back({c, run::rate(c.plain_wrong, c.trials), run::rate(c.fused_wrong, c.trials)});
  contraction_table().write(folder, contractions);
}

std::vector<run::TableDescription> known_tables() {
  return {onset_table().description(), contraction_table().description()};
}

}  // namespace touchstone::stability
