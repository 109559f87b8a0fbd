// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <tuple>
#include <vector>

#include "experiments/cases/failures.h"
#include "experiments/program/statistics/errors.h"
#include "experiments/program/sweep.h"
#include "experiments/program/table.h"

namespace touchstone::tradeoff {

using Settings = cases::CrossingSettings;

/// Slow methods are asked about the first of every kSlowStride samples only; the others about all.
inline constexpr std::uint64_t kSlowStride = 4;

/// The placements of polygons: exactly planar ones, and rotated ones, whose vertices are rounded.
inline constexpr std::array kPlacements{workloads::Placement::Planar, workloads::Placement::Rotated};

/// Offsets of up to this many u x size from a threshold count as near: there most doubles begin to fail.
inline constexpr double kNear = 1;

/// The answers to cases::test_at.
struct Answers : cases::CrossingFailures {
  std::uint64_t overflowed = 0;  ///< of the wrong ones: those of samples at which the whole answer is not finite

  auto members() { return std::tuple_cat(CrossingFailures::members(), std::tie(overflowed)); }
};

/// The numbers whose errors are measured in units in the last place.
enum class Quantity { Distance, Point };
inline constexpr std::array kQuantities{Quantity::Distance, Quantity::Point};
[[nodiscard]] std::string_view to_string(Quantity quantity);

/// Errors of one quantity, in units in the last place, for radii at their threshold.
struct UlpErrors {
  std::uint64_t asked = 0;
  statistics::Distribution known;  ///< of the answers that give the quantity; infinite if it is not finite

  auto members() { return std::tie(asked, known); }
  /// Returns a quantile over the answers that give it as finite numbers. Requires at least one.
  [[nodiscard]] double quantile_of_finite(double share) const;
};

/// A sample with the largest error seen; the earliest of several.
struct Worst {
  double ulps = 0;
  std::uint64_t n = 0;
  std::size_t stratum = 0;

  auto members() { return std::tie(ulps, n, stratum); }
  Worst& operator+=(const Worst& other);
};

/// The results of one method in one stratum.
struct MethodErrors {
  std::vector<Answers> offsets = std::vector<Answers>(cases::all_offsets().size());
  std::uint64_t samples = 0;  ///< the number of samples that it was asked about
  std::array<UlpErrors, kQuantities.size()> ulps;
  std::array<Worst, kQuantities.size()> worst;

  /// Returns the sum over the offsets near the threshold.
  [[nodiscard]] Answers near_threshold() const;
  /// Returns the largest offset with a failure, in u x size, at either side: half of the least one if only the double
  /// nearest to the distance has one, and 0 if there is none.
  [[nodiscard]] double reach() const;
  auto members() { return std::tie(offsets, samples, ulps, worst); }
};

/// The results of all methods and strata. Sums do not depend on their order.
struct Errors {
  std::vector<std::vector<MethodErrors>> at;  ///< by stratum (cases::all_strata), then method
  std::uint64_t samples = 0;                  ///< complete samples per stratum: fewer than requested if stopped
  std::uint64_t missing = 0;                  ///< samples, over all strata, for which no polygon or ball was found

  /// Returns the sum of one method over several strata.
  [[nodiscard]] MethodErrors sum(const std::vector<std::size_t>& strata, std::size_t method) const;
  /// Returns the number of polygons behind such a sum, on which limits are based: each sample has its own.
  [[nodiscard]] std::uint64_t polygons(const std::vector<std::size_t>& strata, std::size_t method) const;
  auto members() { return std::tie(at, samples, missing); }
};

[[nodiscard]] inline std::uint64_t items_done(const Errors& errors) { return errors.samples; }

/// Returns empty results.
[[nodiscard]] Errors no_errors(const Settings& settings);

/// Asks every method about the balls of all crossings (workloads) of those samples that `errors` does not contain yet,
/// and about point and distance of those whose radius is at its threshold.
///
/// The result is a function of the settings and the number of samples done; threads,
/// stops and the other families and methods do not change it. A run stopped after m samples equals a run of m samples.
void measure_errors(const Settings& settings, const program::RunControl& control, Errors& errors);

/// errors.csv, bands.csv, points.csv, and worst.jsonl: the case of the worst error of each placement, method and
/// quantity that ever has an error, in the contract's form; `expected` holds the exact value of that quantity.
///
/// Byte for byte the same for the same settings, whatever the threads. Throws std::runtime_error, which names the file,
/// if it cannot be written. tables() says what the tables hold.
void write_errors(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);

}  // namespace touchstone::tradeoff
