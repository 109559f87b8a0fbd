// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/run/table.h"
#include "experiments/run/timing/measurement.h"
#include "experiments/studies/tunnelling/misses.h"

namespace touchstone::tunnelling {

// tables() says what the tables hold. Each function throws std::runtime_error, which names the file, if it cannot be
// written.

/// misses.csv: byte for byte the same for the same settings and number of samples.
void write_misses(const std::filesystem::path& folder, const Misses& misses);
/// cost.csv: times, which differ from run to run.
void write_cost(const std::filesystem::path& folder, const timing::Result& cost);

[[nodiscard]] std::vector<run::TableDescription> tables();

/// Returns the tables for the terminal.
[[nodiscard]] std::string table(const Misses& misses);
[[nodiscard]] std::string table(const timing::Result& cost);

}  // namespace touchstone::tunnelling
