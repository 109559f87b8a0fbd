// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/studies/stability/contraction.h"
#include "experiments/studies/stability/false_areas.h"
#include "experiments/studies/stability/onset.h"
#include "experiments/studies/stability/summary.h"

namespace touchstone::stability {

/// Results that reproduce experience known from the literature.
struct Known {
  Onset onset;
  std::vector<ContractionCount> contractions;
  std::vector<stability::FalseArea> areas;
};

// Results only: byte for byte the same for the same settings, whatever the threads and processes. Each throws
// std::runtime_error, which names the file, where it cannot be written. Limits: Clopper-Pearson, 95 %.

/// failures.csv: one line per axis, level, nearness, test and method. first-failure.csv: the first level with a
/// failure, and the first at which more than half of the samples failed (empty: none seen); the level before the first
/// failure (the last level if none was seen), how many samples did not fail there and the upper limit of their rate;
/// failures, rate and limits over all levels together.
void write_failures(const std::filesystem::path& folder, const Settings& settings, const Summary& summary);
/// errors.csv: one line per axis, level, method and quantity: quantiles of the relative error and of that in ulps
/// (statistics::Distribution says how exact).
void write_errors(const std::filesystem::path& folder, const Settings& settings, const Summary& summary);
/// tightness.csv: one line per bounded quantity, axis (and `all`) and level: quantiles of |computed - exact| / bound.
/// conditions.csv: single observations from the first samples of each level: condition and relative error.
void write_bounds(const std::filesystem::path& folder, const Settings& settings, const Summary& summary);
/// worst.jsonl: the worst case of each axis and method, as `touchstone judge --methods NAME` takes it; the method is
/// its first tag. Axes that compare with an intended motion and those of the floating-point mode have none.
void write_worst(const std::filesystem::path& folder, const Summary& summary);
/// onset.csv: one line per distance from the origin, method and offset. contraction.csv: one line per sign and family.
/// areas.csv: one line per outline.
void write_known(const std::filesystem::path& folder, const Known& known);

/// Returns the tables for the terminal, with their legend.
[[nodiscard]] std::string table(const Settings& settings, const Summary& summary, const Known& known);

}  // namespace touchstone::stability
