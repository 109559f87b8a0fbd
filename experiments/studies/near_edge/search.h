// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/studies/near_edge/climb.h"
#include "experiments/studies/near_edge/counts.h"
#include "experiments/studies/near_edge/study.h"

namespace touchstone::near_edge {

/// Where the search looks: rotated polygons of one family at one distance from the origin, at one threshold.
struct Region {
  std::size_t stratum;
  double origin_distance;  ///< in sizes
};

/// Those of the families, at every distance of kSearchDistances.
[[nodiscard]] std::vector<Region> search_regions(const std::vector<workloads::Family>& families);
inline constexpr double kSearchDistances[] = {0, 1e3, 1e6};

/// A sample and how far from its threshold a method is wrong about it, as a share of its size.
struct Find {
  double share = 0;
  std::uint64_t n = 0;

  /// Further away first; of those equally far the first.
  friend bool operator<(const Find& a, const Find& b) { return a.share != b.share ? a.share > b.share : a.n < b.n; }
  friend bool operator==(const Find&, const Find&) = default;
};

/// What random samples of one region showed of one method.
struct Onset {
  static constexpr std::size_t kMostKept = 2;

  std::vector<std::uint64_t> wrong = std::vector<std::uint64_t>(kMostExponent + 1);  ///< [k]: samples wrong at 2^-k
  std::uint64_t samples = 0;
  std::vector<Find> furthest;  ///< the first ones

  Onset& operator+=(const Onset& other);
};

/// Random samples of all regions and methods: sums do not depend on their order.
struct Onsets {
  std::vector<Onset> all;     ///< [region][method]
  std::uint64_t done = 0;     ///< samples of each region
  std::uint64_t missing = 0;  ///< samples, of all, that were not found

  Onsets& operator+=(const Onsets& other);
};

/// A case about which a method is wrong far from the threshold, found by climbing.
struct Worst {
  double share = 0;          ///< how far from the threshold, of the size; 0 where none was found
  std::uint64_t n = 0;       ///< of the sample that the climb began at
  std::int64_t doubles = 0;  ///< the same offset in doubles; negative: a smaller radius, or a smaller coordinate
  std::string line;          ///< the case as JSON, with the one key expected that the method gets wrong

  friend bool operator==(const Worst&, const Worst&) = default;
};

/// The furthest of each region and method: sums do not depend on their order.
struct WorstCases {
  std::vector<Worst> all;          ///< [region][method]
  std::uint64_t wrong_truths = 0;  ///< that `exact` did not confirm: a defect of this program

  WorstCases& operator+=(const WorstCases& other);
};

// Throws nlohmann::json::exception where something is missing.
void to_json(nlohmann::ordered_json& json, const Onsets& onsets);
void from_json(const nlohmann::json& json, Onsets& onsets);
void to_json(nlohmann::ordered_json& json, const WorstCases& worst);
void from_json(const nlohmann::json& json, WorstCases& worst);

/// What no sample has been added to yet.
[[nodiscard]] Onsets no_onsets(const Settings& settings);

/// Measures how far from the threshold each method is wrong about those of `samples` samples of every region that the
/// onsets do not hold yet, and adds them. Returns how many they then hold.
std::uint64_t run_onsets(const Settings& settings, std::uint64_t samples, const harness::RunControl<Onsets>& control,
                         Onsets& onsets);

/// Climbs from the furthest samples of each region and method. At the first process: a function of settings and onsets,
/// whatever the processes and threads; each case is confirmed by `exact`. `onsets` is the first process's. Returns how
/// many climbs were done, of climb_count(settings).
std::uint64_t run_climbs(const Settings& settings, const harness::RunControl<WorstCases>& control, const Onsets& onsets,
                         WorstCases& worst);
[[nodiscard]] std::uint64_t climb_count(const Settings& settings);

}  // namespace touchstone::near_edge
