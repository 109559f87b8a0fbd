// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>
#include <vector>

#include "experiments/harness/distribution.h"
#include "experiments/harness/run_control.h"
#include "experiments/studies/stability/study.h"

namespace touchstone::stability {

/// Of the samples of a cell; one fails if the method is wrong with any of its balls.
struct Tally {
  std::uint64_t failed = 0, samples = 0;
  std::uint64_t wrong = 0, balls = 0;

  Tally& operator+=(const Tally& other);
  [[nodiscard]] double rate() const {
    return samples == 0 ? 0 : static_cast<double>(failed) / static_cast<double>(samples);
  }
};

struct ErrorSummary {
  statistics::Distribution relative, ulps;
};

/// Observations on one polygon are not independent, polygons are: one fails if a bound is exceeded with any ball.
struct BoundSummary {
  statistics::Distribution tightness;
  std::uint64_t exceeded = 0;
  std::uint64_t failed = 0, polygons = 0;

  BoundSummary& operator+=(const BoundSummary& other);
};

/// Points of pictures are kept of so many samples of a level.
inline constexpr std::uint64_t kSamplesShown = 2;

/// A point of a picture: a rounding error beside the condition that bounds it.
struct ConditionPoint {
  std::size_t level, quantity;
  double condition, relative_error;
};

/// What the tables are made of. Axes and methods by their place in the settings. Sums do not depend on their order.
struct Summary {
  using Cell = std::tuple<std::size_t, Nearness, Test, std::size_t, std::size_t>;  ///< axis, ., ., method, level
  using ErrorCell = std::tuple<std::size_t, Quantity, std::size_t, std::size_t>;   ///< axis, ., method, level
  using BoundCell = std::tuple<std::size_t, std::size_t, std::size_t>;             ///< quantity, axis, level

  void add(const Block& block);
  Summary& operator+=(const Summary& other);

  std::uint64_t blocks = 0;
  std::map<Cell, Tally> failures;
  std::map<ErrorCell, ErrorSummary> errors;
  std::map<BoundCell, BoundSummary> bounds;
  std::map<std::size_t, BoundSummary> all_bounds;               ///< by quantity, over all axes
  std::map<std::uint64_t, std::vector<ConditionPoint>> points;  ///< of a few samples, by block
  std::vector<std::vector<std::optional<WorstCase>>> worst;     ///< of each axis and method
  std::vector<std::uint64_t> missing;                           ///< of each axis
  std::uint64_t confirmed = 0, disputed = 0;

  /// Samples of each axis, all done.
  [[nodiscard]] std::uint64_t samples() const { return blocks / missing.size(); }
  /// Nothing where the method has no such test, or was not asked.
  [[nodiscard]] const Tally* at(std::size_t axis, Nearness nearness, Test test, std::size_t method,
                                std::size_t level) const;
  /// The first level at which more than this share of the samples failed.
  [[nodiscard]] std::optional<std::size_t> first_level(const Settings& settings, std::size_t axis, Nearness nearness,
                                                       Test test, std::size_t method, double share) const;
  /// Over all axes that are compared with the doubles asked about: wrong answers and answers, to every test, in `wrong`
  /// and `balls`; polygons in `samples`, of which those with a wrong final answer within one double in `failed`.
  [[nodiscard]] Tally total(const Settings& settings, std::size_t method) const;

 private:
  void add_bounds(const Block& block, std::size_t axis);
};

// Every bit of every number. Throws nlohmann::json::exception where something is missing.
void to_json(nlohmann::ordered_json& json, const Summary& summary);
void from_json(const nlohmann::json& json, Summary& summary);

/// What no block has been added to yet.
[[nodiscard]] Summary no_summary(const Settings& settings);

/// Asks about the blocks that the summary does not hold yet and adds them. At the first process, it then is a function
/// of the settings and the number of its blocks: of the first ones, whatever threads, processes and stops.
void run_study(const Settings& settings, const harness::RunControl<Summary>& control, Summary& summary);

}  // namespace touchstone::stability
