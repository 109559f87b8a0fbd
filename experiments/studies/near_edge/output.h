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

/// rates.csv: one line per family (then `all`), placement, threshold, test, method and tested offset.
void write_rates(const std::filesystem::path& folder, const Settings& settings, const Counts& counts);
/// bands.csv: one line per family (then `all`), placement, threshold, test and method: the number of samples that
/// failed at any offset, all trials, and the lowest and highest offsets at which a failure was seen (empty if none
/// was).
void write_bands(const std::filesystem::path& folder, const Settings& settings, const Counts& counts);
/// disagreements.jsonl: the first balls for which `exact` differs from the truth that was used, for `touchstone judge`;
/// empty if it never differed.
void write_disagreements(const std::filesystem::path& folder, const Result& result);
/// map-<spot>-<test>-<distance>.csv: one line per pixel, row by row from the top: the truth and each method's verdict,
/// in letters.
void write_maps(const std::filesystem::path& folder, const Settings& settings, const std::vector<Map>& maps);

/// onset.csv: one line per family (then `all`), threshold, distance, method and exponent k: the number of samples in
/// which the method is wrong about a ball 2^-k of the size from the threshold, on either side.
void write_onsets(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets);
/// worst.csv: one line per family, threshold, distance and method: the furthest offset at which the method was seen to
/// be wrong, as a share of the size, among random samples and after climbing; the latter also in doubles, with its
/// sample. worst.jsonl: these cases, for `touchstone judge`.
void write_worst(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets,
                 const WorstCases& worst);

/// Returns the table of a search for the terminal: one line per threshold, distance and method, over all families.
[[nodiscard]] std::string search_table(const Settings& settings, const Onsets& onsets, const WorstCases& worst);

/// Returns the table for the terminal, with its legend: one line per method, threshold and test, over all families and
/// placements.
[[nodiscard]] std::string table(const Settings& settings, const Counts& counts);

}  // namespace touchstone::near_edge
