// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "experiments/cases/failures.h"
#include "experiments/run/statistics/errors.h"
#include "experiments/run/sweep.h"
#include "experiments/run/table.h"
#include "experiments/studies/stability/known.h"
#include "experiments/studies/stability/measure.h"

namespace touchstone::stability {

using cases::SampledFailures;

/// The checks of a bound. Polygons are independent, observations on one polygon are not: a polygon fails if a bound is
/// exceeded with any ball.
struct BoundSummary {
  statistics::Distribution tightness;
  std::uint64_t exceeded = 0;
  std::uint64_t failed = 0, polygons = 0;

  auto members() { return std::tie(tightness, exceeded, failed, polygons); }
};

/// The number of samples of a level whose points are kept for pictures.
inline constexpr std::uint64_t kSamplesShown = 2;

/// A point of a picture: a rounding error and the condition that bounds it.
struct ConditionPoint {
  std::size_t level, quantity;
  double condition, relative_error;

  auto members() { return std::tie(level, quantity, condition, relative_error); }
};

/// The data of the tables. Axes and methods are identified by their index in the settings. The result does not depend
/// on the order of additions.
struct Summary {
  using Cell = std::tuple<std::size_t, Nearness, Test, std::size_t, std::size_t>;  ///< axis, ., ., method, level
  using ErrorCell = std::tuple<std::size_t, Quantity, std::size_t, std::size_t>;   ///< axis, ., method, level
  using BoundCell = std::tuple<std::size_t, std::size_t, std::size_t>;             ///< quantity, axis, level

  void add(const Block& block);
  Summary& operator+=(const Summary& other);

  std::uint64_t blocks = 0;
  std::map<Cell, SampledFailures> failures;  ///< a sample fails if the method is wrong with any of its balls
  std::map<ErrorCell, statistics::Distribution> errors;  ///< relative
  std::map<BoundCell, BoundSummary> bounds;
  std::map<std::size_t, BoundSummary> all_bounds;               ///< by quantity, over all axes
  std::map<std::uint64_t, std::vector<ConditionPoint>> points;  ///< from a few samples, by block
  std::vector<std::vector<std::optional<WorstCase>>> worst;     ///< for each axis and method
  std::vector<std::uint64_t> missing;                           ///< for each axis
  std::uint64_t confirmed = 0, disputed = 0;

  auto members() {
    return std::tie(blocks, failures, errors, bounds, all_bounds, points, worst, missing, confirmed, disputed);
  }

  /// Returns the number of samples of each axis that are complete.
  [[nodiscard]] std::uint64_t samples() const { return blocks / missing.size(); }
  /// Returns nothing if the method has no such test, or was not asked.
  [[nodiscard]] const SampledFailures* at(std::size_t axis, Nearness nearness, Test test, std::size_t method,
                                          std::size_t level) const;
  /// Returns the first level at which more than this share of the samples failed.
  [[nodiscard]] std::optional<std::size_t> first_level(const Settings& settings, std::size_t axis, Nearness nearness,
                                                       Test test, std::size_t method, double share) const;
  /// Sums over all axes that are compared with the given doubles: the answers to every test; samples for their final
  /// answers within one double.
  [[nodiscard]] SampledFailures total(const Settings& settings, std::size_t method) const;

 private:
  void add_bounds(const Block& block, std::size_t axis);
};

[[nodiscard]] inline std::uint64_t items_done(const Summary& summary) { return summary.blocks; }

/// Returns an empty summary.
[[nodiscard]] Summary no_summary(const Settings& settings);

/// Computes the blocks that the summary does not contain yet and adds them. The result is a
/// function of the settings and the number of its blocks, which are the first ones, independent of threads
/// and stops.
void run_study(const Settings& settings, const run::RunControl& control, Summary& summary);

// Results only: byte for byte the same for the same settings, whatever the threads. Each throws std::runtime_error,
// which names the file, if it cannot be written. tables() says what the tables hold.

void write_failures(const std::filesystem::path& folder, const Settings& settings, const Summary& summary);
void write_errors(const std::filesystem::path& folder, const Settings& settings, const Summary& summary);
void write_bounds(const std::filesystem::path& folder, const Settings& settings, const Summary& summary);
/// worst.jsonl: the worst case of each axis and method, as `touchstone judge --methods NAME` takes it; the method is
/// its first tag. Axes that compare with an intended motion and those of the floating-point mode have none.
void write_worst(const std::filesystem::path& folder, const Summary& summary);

[[nodiscard]] std::vector<run::TableDescription> tables();

/// Returns the tables for the terminal, with their legend.
[[nodiscard]] std::string table(const Settings& settings, const Summary& summary, const Known& known);

}  // namespace touchstone::stability
