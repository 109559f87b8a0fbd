// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/run/table.h"
#include "experiments/studies/motions/errors.h"
#include "experiments/studies/motions/grazing_pass.h"

namespace touchstone::motions {

// Results only: byte for byte the same for the same settings and number of samples. Each throws std::runtime_error,
// which names the file, if it cannot be written. tables() says what the tables hold.

/// ways.csv and thresholds.csv.
void write_errors(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);
/// furthest.jsonl: for each method, the wrong answer furthest from its threshold, as cases.
void write_furthest(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);
/// pass.csv and pass-scene.csv.
void write_pass(const std::filesystem::path& folder, const GrazingPass& pass, const std::vector<Said>& said);

[[nodiscard]] std::vector<run::TableDescription> tables();

/// Returns the table of all ways for the terminal.
[[nodiscard]] std::string table(const Settings& settings, const Errors& errors);

}  // namespace touchstone::motions
