// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/tunnelling/measure.h"

namespace touchstone::tunnelling {
namespace {

struct MissRow {
  double radius;
  std::uint64_t steps, contacts, missed, beside;
  program::Rate rate;
};

const program::Table<MissRow>& misses_table() {
  static const program::Table<MissRow> table(
      "misses.csv", "a radius and a number of steps",
      program::all_columns<MissRow>(
          {{{"radius", "the radius of the ball, as a share of the polygon's size", &MissRow::radius},
            {"steps", "equal steps of a way as long as the polygon's size", &MissRow::steps},
            {"contacts", "motions that touch, by the exact sweep", &MissRow::contacts},
            {"missed", "those of which no place between steps touches", &MissRow::missed}},
           program::rate_columns<MissRow>("missed contacts", &MissRow::rate),
           {{"beside",
             "motions that do not touch, although a place on them does, once rounded to doubles; at any "
             "number of steps",
             &MissRow::beside}}}));
  return table;
}

struct CostRow {
  const timing::Measured* measured;
  timing::Quartiles nanoseconds;
  std::optional<timing::Quartiles> ratio;
};

const program::Table<CostRow>& cost_table() {
  constexpr const char* kTime = "{:.1f}";
  constexpr const char* kRatio = "{:.3g}";
  const auto time = [](double timing::Quartiles::*part) {
    return [part](const CostRow& row) { return row.nanoseconds.*part; };
  };
  const auto ratio = [](double timing::Quartiles::*part) {
    return [part](const CostRow& row) { return row.ratio ? std::optional((*row.ratio).*part) : std::nullopt; };
  };
  static const program::Table<CostRow> table(
      "cost.csv", "a way of asking about a motion; a measurement, which differs from run to run",
      {{"asked", "the exact sweep, or a number of steps", [](const CostRow& row) { return row.measured->name; }},
       {"motions", "motions", [](const CostRow& row) { return row.measured->queries; }},
       {"repetitions", "turns", [](const CostRow& row) { return row.measured->nanoseconds.size(); }},
       {"lower_quartile_ns", "a motion, over the turns", time(&timing::Quartiles::lower), kTime},
       {"median_ns", "the same, median", time(&timing::Quartiles::median), kTime},
       {"upper_quartile_ns", "the same, upper quartile", time(&timing::Quartiles::upper), kTime},
       {"lower_quartile_ratio", "to the contact by the exact sweep, turn by turn", ratio(&timing::Quartiles::lower),
        kRatio},
       {"median_ratio", "the same, median", ratio(&timing::Quartiles::median), kRatio},
       {"upper_quartile_ratio", "the same, upper quartile", ratio(&timing::Quartiles::upper), kRatio}});
  return table;
}

std::vector<MissRow> rows_of(const Misses& misses) {
  std::vector<MissRow> rows;
  for (std::size_t i = 0; i < kRadii.size(); ++i)
    for (std::size_t level = 0; level <= kMostLevel; ++level) {
      const Contacts& contacts = misses.of[i];
      rows.push_back({kRadii[i], std::uint64_t{1} << level, contacts.all, contacts.missed[level], contacts.beside,
                      program::rate(contacts.missed[level], contacts.all)});
    }
  return rows;
}

std::vector<CostRow> rows_of(const timing::Result& cost) {
  std::vector<CostRow> rows;
  for (const timing::Measured& m : cost.candidates)
    if (!m.nanoseconds.empty())
      rows.push_back({&m, timing::quartiles(m.nanoseconds),
                      m.ratios.empty() ? std::nullopt : std::optional(timing::quartiles(m.ratios))});
  return rows;
}

}  // namespace

void write_misses(const std::filesystem::path& folder, const Misses& misses) {
  misses_table().write(folder, rows_of(misses));
}

void write_cost(const std::filesystem::path& folder, const timing::Result& cost) {
  cost_table().write(folder, rows_of(cost));
}

std::vector<program::TableDescription> tables() { return {misses_table().description(), cost_table().description()}; }

std::string table(const Misses& misses) { return misses_table().aligned(rows_of(misses)); }
std::string table(const timing::Result& cost) { return cost_table().aligned(rows_of(cost)); }

}  // namespace touchstone::tunnelling
