// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/run/table.h"
#include "experiments/studies/soak/tally.h"

namespace touchstone::soak {

// Results only: byte for byte the same for the same seed, first case and number of cases, whatever the number of
// threads and interruptions. Each throws std::runtime_error, which names the file, if it cannot be written.
// tables() says what the table holds.

void write_counts(const std::filesystem::path& folder, const Tally& tally);
/// differences.jsonl: the first cases that differed, for `touchstone judge --methods filtered`; empty if none did.
void write_differences(const std::filesystem::path& folder, const Tally& tally);

[[nodiscard]] std::vector<run::TableDescription> tables();

/// Returns the table for the terminal, with the verdict below it.
[[nodiscard]] std::string table(const Tally& tally);

}  // namespace touchstone::soak
