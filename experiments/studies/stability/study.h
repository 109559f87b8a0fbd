// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/studies/stability/bound.h"
#include "experiments/studies/stability/probe.h"

namespace touchstone::stability {

struct Settings {
  std::vector<const cases::Method*> methods;
  std::vector<Axis> axes;
  std::uint64_t samples = 1;  ///< of each level; Level::one_in makes it fewer
  std::uint64_t seed = 1;
  unsigned threads = 1;     ///< of each process
  double bound_factor = 1;  ///< what every bound is multiplied with: a test plants wrong ones
};

/// What one method did in one test of one sample. Trials of one sample are not independent, samples are: a sample fails
/// if it does with any ball.
struct TestResult {
  std::size_t level, method;
  Test test;
  Nearness nearness;
  std::uint64_t wrong, asked;
};

enum class Quantity { Distance, Point };
[[nodiscard]] std::string_view word(Quantity quantity);

/// Of `distance`: the difference from the correctly rounded one, relative to it and in its ulps. Of `point`: the
/// largest difference in a coordinate, relative to the largest coordinate of the correctly rounded one and in its ulps.
/// Infinite where the method's answer is not finite.
struct NumberError {
  std::size_t level, method;
  Quantity quantity;
  double relative, ulps;
};

struct BoundResult {
  std::size_t level;
  Observation observation;
};

/// What of a sample is the worst of one method, as a case for `touchstone judge`. A wrong final answer (contact or
/// none) is worse than a right one, and worse the further from the boundary it is; then the error of the distance
/// counts; of equals the one of the first block.
struct WorstCase {
  std::size_t level, method;
  int rank;      ///< 0: the final answer is right; else 1 + its nearness
  double error;  ///< of the distance, relative; 0 where the method gives none
  std::uint64_t block;
  std::string line;

  auto members() { return std::tie(level, method, rank, error, block, line); }
  [[nodiscard]] bool worse_than(const WorstCase& other) const {
    if (rank != other.rank) return rank > other.rank;
    return error != other.error ? error > other.error : block < other.block;
  }
};

/// One sample of every level of an axis. Blocks are numbered sample by sample, axis by axis.
struct Block {
  std::uint64_t number = 0;
  Axis axis{};
  std::uint64_t sample = 0;
  std::vector<TestResult> tests;
  std::vector<NumberError> errors;
  std::vector<BoundResult> bounds;
  std::vector<WorstCase> worst;               ///< at most one a method
  std::uint64_t missing = 0;                  ///< levels at which no polygon was found
  std::uint64_t confirmed = 0, disputed = 0;  ///< truths by `filtered` that `exact` was asked about
};

/// Bounds are observed on one of so many samples that are drawn at a level. As many in a row are taken, because scenes
/// alternate with the sample's number: all kinds of them take part.
inline constexpr std::uint64_t kBoundsOneIn = 4;
/// The number of a sample among those on which bounds are observed; nothing if it is none of them.
[[nodiscard]] std::optional<std::uint64_t> bounds_number(Axis axis, std::size_t level, std::uint64_t sample);
/// Bounds are observed on polygons of at most so many vertices; cases are kept of smaller ones.
inline constexpr std::size_t kMostForBounds = 1100, kMostForCases = 200;

/// Draws one sample of every level of an axis and asks every method.
///
/// A function of the settings but for `threads`; what it says of an axis and a method does not depend on which others
/// are asked for. A method that throws is wrong.
[[nodiscard]] Block ask_block(const Settings& settings, std::uint64_t number);

/// The number of blocks of a study.
[[nodiscard]] std::uint64_t block_count(const Settings& settings);

}  // namespace touchstone::stability
