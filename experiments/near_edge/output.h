// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/near_edge/map.h"
#include "experiments/near_edge/study.h"

namespace touchstone::near_edge {

// Results only: byte for byte the same for the same settings, whatever the number of threads. Each throws
// std::runtime_error, which names the file, where it cannot be written. Limits: Clopper-Pearson, 95 %.

/// rates.csv: a line a family (then `all`), placement, threshold, test, method and offset that was tried.
void write_rates(const std::filesystem::path& folder, const Settings& settings, const Counts& counts);
/// bands.csv: a line a family (then `all`), placement, threshold, test and method: how many samples failed at some
/// offset, all trials, and the lowest and highest offsets at which a failure was seen (empty if none was).
void write_bands(const std::filesystem::path& folder, const Settings& settings, const Counts& counts);
/// map-<test>-<distance>.csv: a line a pixel, row by row from the top: the truth and each method's verdict, in letters.
void write_maps(const std::filesystem::path& folder, const Settings& settings, const std::vector<Map>& maps);

/// The table for the terminal, with its legend: a line a method, threshold and test, over all families and placements.
[[nodiscard]] std::string table(const Settings& settings, const Counts& counts);

}  // namespace touchstone::near_edge
