// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/run/table.h"
#include "experiments/studies/near_edge/map.h"
#include "experiments/studies/near_edge/search.h"
#include "experiments/studies/near_edge/study.h"

namespace touchstone::near_edge {

// Results only: byte for byte the same for the same settings, whatever the number of threads. Each throws
// std::runtime_error, which names the file, if it cannot be written. tables() says what the tables hold.

void write_rates(const std::filesystem::path& folder, const Settings& settings, const Counts& counts);
void write_bands(const std::filesystem::path& folder, const Settings& settings, const Counts& counts);
/// disagreements.jsonl: the first balls for which `exact` differs from the truth that was used, for `touchstone judge`;
/// empty if it never differed.
void write_disagreements(const std::filesystem::path& folder, const Result& result);
void write_maps(const std::filesystem::path& folder, const Settings& settings, const std::vector<Map>& maps);
void write_onsets(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets);
/// Also writes worst.jsonl: these cases, for `touchstone judge`.
void write_worst(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets,
                 const WorstCases& worst);

/// @{
/// Returns what the tables hold.
[[nodiscard]] std::vector<run::TableDescription> tables();
[[nodiscard]] std::vector<run::TableDescription> search_tables();
/// @}

/// Returns the table of a search for the terminal: one line per threshold, distance and method, over all families.
[[nodiscard]] std::string search_table(const Settings& settings, const Onsets& onsets, const WorstCases& worst);

/// Returns the table for the terminal, with its legend: one line per method, threshold and test, over all families and
/// placements.
[[nodiscard]] std::string table(const Settings& settings, const Counts& counts);

}  // namespace touchstone::near_edge
