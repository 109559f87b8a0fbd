// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "experiments/stability/study.h"

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

/// Ascending numbers.
class Distribution {
 public:
  void add(double number) { numbers_.push_back(number); }
  void sort();
  [[nodiscard]] std::size_t count() const { return numbers_.size(); }
  [[nodiscard]] std::size_t infinite() const;
  /// The smallest number that at least this share does not exceed. Requires a number.
  [[nodiscard]] double quantile(double share) const;
  [[nodiscard]] double largest() const { return numbers_.back(); }

 private:
  std::vector<double> numbers_;
};

struct ErrorSummary {
  Distribution relative, ulps;
};

/// Observations on one polygon are not independent, polygons are: one fails if a bound is exceeded with any ball.
struct BoundSummary {
  Distribution tightness;
  std::uint64_t exceeded = 0;
  std::uint64_t failed = 0, polygons = 0;
};

/// What the tables are made of. Axes and methods by their place in the settings.
struct Summary {
  using Cell = std::tuple<std::size_t, Nearness, Test, std::size_t, std::size_t>;  ///< axis, ., ., method, level
  using ErrorCell = std::tuple<std::size_t, Quantity, std::size_t, std::size_t>;   ///< axis, ., method, level
  using BoundCell = std::tuple<std::size_t, std::size_t, std::size_t>;             ///< quantity, axis, level

  Summary(const Settings& settings, const Result& result);

  std::map<Cell, Tally> failures;
  std::map<ErrorCell, ErrorSummary> errors;
  std::map<BoundCell, BoundSummary> bounds;
  std::map<std::size_t, BoundSummary> all_bounds;            ///< by quantity, over all axes
  std::vector<std::vector<std::optional<WorstCase>>> worst;  ///< of each axis and method
  std::vector<std::uint64_t> missing;                        ///< of each axis
  std::uint64_t confirmed = 0, disputed = 0;

  /// Nothing where the method has no such test, or was not asked.
  [[nodiscard]] const Tally* at(std::size_t axis, Nearness nearness, Test test, std::size_t method,
                                std::size_t level) const;
  /// The first level at which more than this share of the samples failed.
  [[nodiscard]] std::optional<std::size_t> first_level(const Settings& settings, std::size_t axis, Nearness nearness,
                                                       Test test, std::size_t method, double share) const;
  /// Over all axes that are compared with the doubles asked about: wrong answers and answers, to every test, in `wrong`
  /// and `balls`; polygons in `samples`, of which those with a wrong final answer within one double in `failed`.
  [[nodiscard]] Tally total(const Settings& settings, std::size_t method) const;
};

}  // namespace touchstone::stability
