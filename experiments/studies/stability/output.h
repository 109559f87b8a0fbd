// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/run/table.h"
#include "experiments/studies/stability/contraction.h"
#include "experiments/studies/stability/onset.h"
#include "experiments/studies/stability/summary.h"

namespace touchstone::stability {

/// Results that reproduce experience known from the literature.
struct Known {
  Onset onset;
  std::vector<ContractionCount> contractions;
};

// Results only: byte for byte the same for the same settings, whatever the threads. Each throws
// std::runtime_error, which names the file, if it cannot be written. tables() says what the tables
// hold.

void write_failures(const std::filesystem::path& folder, const Settings& settings, const Summary& summary);
void write_errors(const std::filesystem::path& folder, const Settings& settings, const Summary& summary);
void write_bounds(const std::filesystem::path& folder, const Settings& settings, const Summary& summary);
/// worst.jsonl: the worst case of each axis and method, as `touchstone judge --methods NAME` takes it; the method is
/// its first tag. Axes that compare with an intended motion and those of the floating-point mode have none.
void write_worst(const std::filesystem::path& folder, const Summary& summary);
void write_known(const std::filesystem::path& folder, const Known& known);

/// @{
/// Returns what the tables hold.
[[nodiscard]] std::vector<run::TableDescription> tables();
[[nodiscard]] std::vector<run::TableDescription> known_tables();
/// @}

/// Returns the tables for the terminal, with their legend.
[[nodiscard]] std::string table(const Settings& settings, const Summary& summary, const Known& known);

}  // namespace touchstone::stability
