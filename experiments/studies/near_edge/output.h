// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/studies/near_edge/map.h"
#include "experiments/studies/near_edge/search.h"
#include "experiments/studies/near_edge/study.h"

namespace touchstone::near_edge {

// Results only: byte for byte the same for the same settings, whatever the number of threads. Each throws
// std::runtime_error, which names the file, where it cannot be written. Limits: Clopper-Pearson, 95 %.

/// rates.csv: a line a family (then `all`), placement, threshold, test, method and offset that was tried.
void write_rates(const std::filesystem::path& folder, const Settings& settings, const Counts& counts);
/// bands.csv: a line a family (then `all`), placement, threshold, test and method: how many samples failed at some
/// offset, all trials, and the lowest and highest offsets at which a failure was seen (empty if none was).
void write_bands(const std::filesystem::path& folder, const Settings& settings, const Counts& counts);
/// disagreements.jsonl: the first balls about which `exact` says otherwise than the truth that was used, for
/// `touchstone judge`; empty if it never did.
void write_disagreements(const std::filesystem::path& folder, const Result& result);
/// map-<spot>-<test>-<distance>.csv: a line a pixel, row by row from the top: the truth and each method's verdict, in
/// letters.
void write_maps(const std::filesystem::path& folder, const Settings& settings, const std::vector<Map>& maps);

/// onset.csv: a line a family (then `all`), threshold, distance, method and exponent k: of how many samples the method
/// is wrong about a ball 2^-k of the size from the threshold, on either side.
void write_onsets(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets);
/// worst.csv: a line a family, threshold, distance and method: the furthest offset at which the method was seen to be
/// wrong, as a share of the size, among random samples and after climbing; the latter in doubles too, and its sample.
/// worst.jsonl: these cases, for `touchstone judge`.
void write_worst(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets,
                 const WorstCases& worst);

/// The table of a search for the terminal: a line a threshold, distance and method, over all families.
[[nodiscard]] std::string search_table(const Settings& settings, const Onsets& onsets, const WorstCases& worst);

/// The table for the terminal, with its legend: a line a method, threshold and test, over all families and placements.
[[nodiscard]] std::string table(const Settings& settings, const Counts& counts);

}  // namespace touchstone::near_edge
