// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "experiments/cases/failures.h"
#include "experiments/cases/method.h"
#include "experiments/program/statistics/errors.h"
#include "experiments/program/sweep.h"
#include "experiments/studies/stability/scene.h"

namespace touchstone::stability {

using cases::SampledFailures;
using cases::Test;

/// The counted tests; edges are compared as lists.
inline constexpr std::array kCountedTests{Test::Plane, Test::Foot, Test::Edges, Test::Contact, Test::Relation};

/// Polygons of more vertices have `filtered` as their truth, which `exact` confirms in part; those of the second number
/// are not kept as cases.
inline constexpr std::size_t kMostForExact = 2000, kMostForCases = 200;

struct Settings {
  std::vector<const cases::Method*> methods;
  std::vector<Axis> axes;
  std::uint64_t samples = 1;  ///< per level; fewer if Level::one_in is greater than 1
  std::uint64_t seed = 1;
  unsigned threads = 1;
};

/// A number of an answer, whose error is relative. For `distance`: the difference from the correctly rounded value,
/// relative to it. For `point`: the largest difference in a coordinate, relative to the largest coordinate of the
/// correctly rounded point. Infinite if the method's answer is not finite.
enum class Quantity { Distance, Point };
[[nodiscard]] std::string_view to_string(Quantity quantity);

/// The worst answer of one method on one axis, as a case for `touchstone judge`; without a line, there is none. A wrong
/// final answer (contact or not) is worse than a right one, and worse the further from the boundary it is; then a
/// larger error of the distance is worse; among equals the first block is taken.
struct WorstCase {
  int rank = 0;      ///< 0 if the final answer is right; otherwise 1 + its nearness
  double error = 0;  ///< of the distance, relative; 0 if the method gives none
  std::uint64_t block = 0;
  std::string line;

  auto members() { return std::tie(rank, error, block, line); }
  [[nodiscard]] bool worse_than(const WorstCase& other) const {
    return std::tuple(rank, error, other.block) > std::tuple(other.rank, other.error, block);
  }
  /// Keeps the worse one.
  WorstCase& operator+=(const WorstCase& other) {
    if (line.empty() || other.worse_than(*this)) *this = other;
    return *this;
  }
};

/// The sum of a study. Methods are identified by their index in the settings.
struct Summary {
  using Cell = std::tuple<Axis, Nearness, Test, std::size_t, std::size_t>;  ///< ., ., ., method, level
  using ErrorCell = std::tuple<Axis, Quantity, std::size_t, std::size_t>;   ///< ., ., method, level

  std::uint64_t blocks = 0;
  std::map<Cell, SampledFailures> failures;  ///< a sample fails if the method is wrong with any of its balls
  std::map<ErrorCell, statistics::Distribution> errors;
  std::map<std::pair<Axis, std::size_t>, WorstCase> worst;  ///< by axis and method
  std::uint64_t missing = 0;                                ///< levels of a sample at which no polygon was found
  std::uint64_t confirmed = 0, disputed = 0;  ///< truths by `filtered` that `exact` confirmed, and contradicted

  auto members() { return std::tie(blocks, failures, errors, worst, missing, confirmed, disputed); }

  /// Returns nothing if the method has no such test, or was not asked.
  [[nodiscard]] const SampledFailures* at(Axis axis, Nearness nearness, Test test, std::size_t method,
                                          std::size_t level) const;
  /// Returns the first level at which a sample failed.
  [[nodiscard]] std::optional<std::size_t> first_failure(Axis axis, Nearness nearness, Test test,
                                                         std::size_t method) const;
};

[[nodiscard]] inline std::uint64_t items_done(const Summary& summary) { return summary.blocks; }

/// Returns the number of blocks of a study. A block is one sample of every level of an axis; blocks are numbered sample
/// by sample, axis by axis.
[[nodiscard]] std::uint64_t block_count(const Settings& settings);

/// Adds the blocks of a part. The sum is a function of the settings and the number of its blocks, which are the first
/// ones, independent of threads and stops; the results of an axis and a method do not depend on the other axes and
/// methods. A method that throws is wrong.
///
/// Balls are placed at, close to and amply off the exact distance, or have their foot at an edge. For OneDouble and
/// Close balls, asks the test that their radius or foot is near to (the plane if the face is nearest, otherwise the
/// edges) and the final answer; for Ample balls, all tests that do not depend on the foot alone. For an intended motion,
/// the truth and the radii are those before it.
void run_study(const Settings& settings, const program::RunControl& control, Summary& summary);

}  // namespace touchstone::stability
