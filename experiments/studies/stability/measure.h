// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/comparison.h"
#include "experiments/studies/stability/bound.h"
#include "experiments/studies/stability/scene.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::stability {

using cases::Test;

/// The counted tests; edges are compared as lists.
inline constexpr std::array kCountedTests{Test::Plane, Test::Foot, Test::Edges, Test::Contact, Test::Relation};

/// The truth about one polygon: `exact`, or for more vertices than kMostForExact `filtered`, with selected answers
/// confirmed by `exact`.
class Oracle {
 public:
  static constexpr std::size_t kMostForExact = 2000;

  explicit Oracle(const Polygon& polygon);

  [[nodiscard]] Answer answer(const Ball& ball) const;
  /// Returns whether `exact` is asked less often than the truth is needed.
  [[nodiscard]] bool spares_exact() const { return filtered_.has_value(); }
  /// Returns whether `exact` gives the same answer.
  [[nodiscard]] bool confirms(const Ball& ball) const;

 private:
  exact::PreparedPolygon exact_;
  std::optional<filtered::PreparedPolygon> filtered_;
};

/// A ball, the tests to ask about it, and the truth.
struct Probe {
  Ball ball;
  cases::PartialAnswer truth;
  Nearness nearness;
  std::vector<Test> tests;
  bool measured;  ///< whether distance and point are compared with the truth
  bool bounded;   ///< whether bounds on rounding errors are observed, at the boundary
};

/// Returns the balls of a scene: for each placement, radii at, close to and amply off the exact distance, or one ball
/// for a foot. For OneDouble and Close balls, asks the test that their radius or foot is near to (the plane if the face
/// is nearest, otherwise the edges) and the final answer; for Ample balls, all tests that do not depend on the foot
/// alone. A placement at distance 0 has no balls. If `oracle` spares `exact`, takes one radius of each nearness.
///
/// For an intended motion, the truth and the radii are those before it.
[[nodiscard]] std::vector<Probe> probes_of(const Scene& scene, const Oracle& oracle);

struct Settings {
  std::vector<const cases::Method*> methods;
  std::vector<Axis> axes;
  std::uint64_t samples = 1;  ///< per level; fewer if Level::one_in is greater than 1
  std::uint64_t seed = 1;
  unsigned threads = 1;
  double bound_factor = 1;  ///< the factor of every bound, with which a test plants wrong ones
};

/// The result of one method in one test of one sample. Samples are independent, the trials of one sample are not: a
/// sample fails if it fails with any ball.
struct TestResult {
  std::size_t level, method;
  Test test;
  Nearness nearness;
  std::uint64_t wrong, asked;
};

enum class Quantity { Distance, Point };
[[nodiscard]] std::string_view to_string(Quantity quantity);

/// The error of a number. For `distance`: the difference from the correctly rounded value, relative to it. For
/// `point`: the largest difference in a coordinate, relative to the largest coordinate of the correctly rounded point.
/// Infinite if the method's answer is not finite.
struct NumberError {
  std::size_t level, method;
  Quantity quantity;
  double relative;
};

struct BoundResult {
  std::size_t level;
  Observation observation;
};

/// The worst result of one method in a sample, as a case for `touchstone judge`. A wrong final answer (contact or not)
/// is worse than a right one, and worse the further from the boundary it is; then a larger error of the distance is
/// worse; among equals the first block is taken.
struct WorstCase {
  std::size_t level, method;
  int rank;      ///< 0 if the final answer is right; otherwise 1 + its nearness
  double error;  ///< of the distance, relative; 0 if the method gives none
  std::uint64_t block;
  std::string line;

  auto members() { return std::tie(level, method, rank, error, block, line); }
  [[nodiscard]] bool worse_than(const WorstCase& other) const {
    if (rank != other.rank) return rank > other.rank;
    return error != other.error ? error > other.error : block < other.block;
  }
};

/// The results of one sample of every level of an axis. Blocks are numbered sample by sample, axis by axis.
struct Block {
  std::uint64_t number = 0;
  Axis axis{};
  std::uint64_t sample = 0;
  std::vector<TestResult> tests;
  std::vector<NumberError> errors;
  std::vector<BoundResult> bounds;
  std::vector<WorstCase> worst;               ///< at most one per method
  std::uint64_t missing = 0;                  ///< the number of levels at which no polygon was found
  std::uint64_t confirmed = 0, disputed = 0;  ///< truths by `filtered` that `exact` confirmed, and contradicted
};

/// Bounds are checked on one in kBoundsOneIn of the samples drawn at a level. They are taken as kBoundsOneIn
/// consecutive samples, because scenes alternate with the sample's number and every kind must be covered.
inline constexpr std::uint64_t kBoundsOneIn = 4;
/// Returns the index of a sample among those on which bounds are checked; nothing for any other sample.
[[nodiscard]] std::optional<std::uint64_t> bounds_number(Axis axis, std::size_t level, std::uint64_t sample);
/// The largest numbers of vertices of polygons on which bounds are checked, and of polygons kept as cases.
inline constexpr std::size_t kMostForBounds = 1100, kMostForCases = 200;

/// Draws one sample of every level of an axis and tests every method.
///
/// A function of the settings except `threads`; the results of an axis and a method do not depend on the other axes and
/// methods. A method that throws is wrong.
[[nodiscard]] Block ask_block(const Settings& settings, std::uint64_t number);

/// Returns the number of blocks of a study.
[[nodiscard]] std::uint64_t block_count(const Settings& settings);

}  // namespace touchstone::stability
