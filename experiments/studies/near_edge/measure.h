// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/cases/failures.h"
#include "experiments/program/sweep.h"
#include "experiments/program/table.h"
#include "experiments/studies/near_edge/properties.h"

namespace touchstone::near_edge {

using cases::CrossingFailures;
using cases::Failures;
using cases::kTests;
using cases::Outcome;
using cases::Test;
using Settings = cases::CrossingSettings;

/// The answers of one method to one test in one stratum.
///
/// Samples are independent, and so are the answers at one offset; answers about one sample at different offsets are
/// not. So confidence limits apply to `samples` and to single offsets, not to all answers.
struct TestFailures {
  std::vector<CrossingFailures> offsets = std::vector<CrossingFailures>(cases::all_offsets().size());
  Failures samples;  ///< a sample fails if an answer at any offset is wrong or undecided

  /// Adds one sample, with the outcomes for each ball of the crossing.
  void add(const cases::Crossing& crossing, const std::vector<cases::Outcomes>& outcomes, bool lifts);
  auto members() { return std::tie(offsets, samples); }
  friend bool operator==(const TestFailures&, const TestFailures&) = default;
};

/// By stratum, test and method (index in the settings).
using Counts = std::vector<std::array<std::vector<TestFailures>, kTests.size()>>;
/// Returns the sum over these strata.
[[nodiscard]] TestFailures sum(const Counts& counts, const std::vector<std::size_t>& strata, Test test,
                               std::size_t method);

/// The answers to `contact` at one range of one property, over all families of exactly planar loops; by method.
struct RangeFailures {
  std::vector<std::vector<CrossingFailures>> offsets;  ///< [method][offset]

  auto members() { return std::tie(offsets); }
  friend bool operator==(const RangeFailures&, const RangeFailures&) = default;
};
/// By threshold (cases::all_thresholds), property and range.
using ByProperty = std::vector<std::vector<std::vector<RangeFailures>>>;

/// The results of the study; sums do not depend on their order.
struct Result {
  Counts counts;
  ByProperty by_property;
  std::uint64_t samples = 0;  ///< complete samples per stratum: fewer than requested if the run was stopped
  std::uint64_t missing = 0;  ///< samples, over all strata, for which no polygon or ball was found

  auto members() { return std::tie(counts, by_property, samples, missing); }
  friend bool operator==(const Result&, const Result&) = default;
};

[[nodiscard]] inline std::uint64_t items_done(const Result& result) { return result.samples; }

/// Returns an empty result.
[[nodiscard]] Result no_result(const Settings& settings);

/// Asks every method about every ball of every crossing of the part, whose truths are those of `exact`, and adds the
/// answers to the result.
///
/// The result is a function of settings and the number of samples done. Threads, stops
/// and the other families and methods do not change the counts of one family and method. A run stopped after m samples
/// equals a run of m samples.
void run_study(const Settings& settings, const program::RunControl& control, Result& result);

/// rates.csv, bands.csv and properties.csv: byte for byte the same for the same settings, whatever the number of threads. Throws
/// std::runtime_error, which names the file, if it cannot be written. tables() says what the tables hold.
void write_failures(const std::filesystem::path& folder, const Settings& settings, const Result& result);

/// Returns what the tables hold, those of the maps included.
[[nodiscard]] std::vector<program::TableDescription> tables();

/// Returns the table of bands for the terminal, over all families, of the test that is decided at each threshold.
[[nodiscard]] std::string table(const Settings& settings, const Counts& counts);

}  // namespace touchstone::near_edge
