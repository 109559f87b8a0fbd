// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "experiments/cases/comparison.h"
#include "experiments/cases/method.h"
#include "experiments/cases/threshold.h"
#include "experiments/harness/distribution.h"
#include "experiments/harness/run_control.h"

namespace touchstone::tradeoff {

struct Settings {
  std::vector<const cases::Method*> methods;
  std::vector<workloads::Family> families;
  std::uint64_t samples = 1;  ///< of each stratum
  std::uint64_t seed = 1;
  unsigned threads = 1;  ///< of each process
};

/// Slow methods are asked about the first of so many samples only, and so on; the others about all.
inline constexpr std::uint64_t kSlowStride = 4;

/// Offsets up to so many doubles from a threshold are near it.
inline constexpr std::int64_t kNear = 8;

/// What is counted across a threshold: the final answer where the radius moves, the foot where the centre does.
[[nodiscard]] cases::Test test_at(cases::Threshold threshold);

struct Tally {
  std::uint64_t wrong = 0, unsure = 0, trials = 0;
  std::uint64_t overflowed = 0;  ///< of the wrong ones: those of samples at which the whole answer is not finite

  [[nodiscard]] std::uint64_t not_right() const { return wrong + unsure; }
  Tally& operator+=(const Tally& other);
  friend bool operator==(const Tally&, const Tally&) = default;
};

/// The numbers whose errors are measured in units in the last place.
enum class Quantity { Distance, Point };
inline constexpr std::array kQuantities{Quantity::Distance, Quantity::Point};
[[nodiscard]] std::string_view word(Quantity quantity);

/// Errors of one quantity, in units in the last place. Asked where the radius is at its threshold.
struct UlpErrors {
  std::uint64_t asked = 0;
  statistics::Distribution known;  ///< of the answers that give the quantity; infinite where it is not finite

  /// Of the answers that give it as finite numbers. Requires one of them.
  [[nodiscard]] double quantile_of_finite(double share) const;
};

/// A sample at which an error is the largest that was seen; the earliest of several.
struct Worst {
  double ulps = 0;
  std::uint64_t n = 0;
  std::size_t stratum = 0;
};

/// What one method did in one stratum.
struct MethodErrors {
  std::vector<Tally> offsets;  ///< by cases::all_offsets
  std::uint64_t samples = 0;   ///< that it was asked about
  std::array<UlpErrors, kQuantities.size()> ulps;
  std::array<Worst, kQuantities.size()> worst;

  /// Over the offsets near the threshold.
  [[nodiscard]] Tally near_threshold() const;
  MethodErrors& operator+=(const MethodErrors& other);
};

/// Sums do not depend on their order.
struct Errors {
  std::vector<std::vector<MethodErrors>> at;  ///< by stratum (cases::all_strata), then method
  std::uint64_t samples = 0;                  ///< of each stratum, all done: fewer than asked for where stopped
  std::uint64_t missing = 0;                  ///< samples, of all, for which no polygon or ball was found

  /// One method in several strata together.
  [[nodiscard]] MethodErrors sum(const std::vector<std::size_t>& strata, std::size_t method) const;
  /// The polygons behind such a sum, which limits are of: the thresholds of a family in a placement share theirs.
  [[nodiscard]] std::uint64_t polygons(const std::vector<std::size_t>& strata, std::size_t method) const;
  Errors& operator+=(const Errors& other);
};

// Every bit of every number. Throws nlohmann::json::exception where something is missing.
void to_json(nlohmann::ordered_json& json, const Errors& errors);
void from_json(const nlohmann::json& json, Errors& errors);

/// What no sample has been added to yet.
[[nodiscard]] Errors no_errors(const Settings& settings);

/// Asks every method about the balls of near_edge's crossings of those samples that `errors` does not hold yet, and
/// about the point and the distance of those whose radius is at its threshold.
///
/// At the first process: a function of the settings and the number of samples done; threads, processes, stops and the
/// other families and methods change nothing. A run that was stopped after m samples equals one of m samples.
void measure_errors(const Settings& settings, const harness::RunControl<Errors>& control, Errors& errors);

}  // namespace touchstone::tradeoff
