// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/run/blocks.h"
#include "experiments/stability/bound.h"
#include "experiments/stability/probe.h"

namespace touchstone::stability {

struct Settings {
  std::vector<const methods::Method*> methods;
  std::vector<Axis> axes;
  std::uint64_t samples = 1;  ///< of each level; Level::one_in makes it fewer
  std::uint64_t seed = 1;
  unsigned threads = 1;
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

/// What of a sample is the worst of one method, as a case for `touchstone judge`. Ranked by how far from the boundary
/// an answer is wrong, then by the error of the distance.
struct WorstCase {
  std::size_t level, method;
  int rank;
  double error;
  std::string line;

  [[nodiscard]] bool worse_than(const WorstCase& other) const {
    return rank != other.rank ? rank > other.rank : error > other.error;
  }
};

/// One sample of every level of an axis.
struct Block {
  Axis axis{};
  std::uint64_t sample = 0;
  std::vector<TestResult> tests;
  std::vector<NumberError> errors;
  std::vector<BoundResult> bounds;
  std::vector<WorstCase> worst;               ///< at most one a method
  std::uint64_t missing = 0;                  ///< levels at which no polygon was found
  std::uint64_t confirmed = 0, disputed = 0;  ///< truths by `filtered` that `exact` was asked about
};

struct Result {
  std::vector<Block> blocks;  ///< sample by sample, axis by axis: the first ones, all done
  std::uint64_t samples;      ///< of each axis, all done
};

/// Bounds are observed on one of so many samples that are drawn at a level, on polygons of at most so many vertices;
/// cases are kept of smaller ones.
inline constexpr std::uint64_t kBoundsOneIn = 4;
inline constexpr std::size_t kMostForBounds = 1100, kMostForCases = 200;

/// Draws every sample and asks every method.
///
/// Blocks are a function of settings alone, not of `threads`; those of one axis and method do not depend on which
/// others are asked for. A method that throws is wrong.
[[nodiscard]] Result run_study(const Settings& settings, const std::atomic<bool>& stop, const run::Progress& progress);

/// The number of blocks that `run_study` reports.
[[nodiscard]] std::uint64_t block_count(const Settings& settings);

}  // namespace touchstone::stability
