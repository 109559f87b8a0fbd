// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/run/table.h"
#include "experiments/studies/tradeoff/errors.h"
#include "experiments/studies/tradeoff/timings.h"

namespace touchstone::tradeoff {

// Each throws std::runtime_error, which names the file, if it cannot be written. Those of errors alone are the same
// byte for byte for the same settings, whatever the threads. tables() says what the
// tables hold.

void write_errors(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);
void write_bands(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);
void write_points(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);
/// worst.jsonl: the case of the worst error of each placement, method and quantity that ever has an error, in the
/// contract's form; `expected` holds the exact value of that quantity.
void write_worst(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);
void write_timings(const std::filesystem::path& folder, const std::vector<Timing>& timings);
void write_front(const std::filesystem::path& folder, const Settings& settings, const Errors& errors,
                 const std::vector<Timing>& timings);

/// Returns what the tables hold.
[[nodiscard]] std::vector<run::TableDescription> tables();

/// Returns the tables for the terminal, all families together, with their legend.
[[nodiscard]] std::string table(const Settings& settings, const Errors& errors, const std::vector<Timing>& timings);

}  // namespace touchstone::tradeoff
