// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/studies/near_edge/climb.h"
#include "experiments/studies/near_edge/counts.h"
#include "experiments/studies/near_edge/study.h"

namespace touchstone::near_edge {

/// A region of the search: rotated polygons of one family at one distance from the origin, at one threshold.
struct Region {
  std::size_t stratum;
  double origin_distance;  ///< in sizes
};

/// Returns the regions of the families, at every distance of kSearchDistances.
[[nodiscard]] std::vector<Region> search_regions(const std::vector<workloads::Family>& families);
inline constexpr double kSearchDistances[] = {0, 1e3, 1e6};

/// A sample and the distance from its threshold at which a method is wrong about it, as a share of its size.
struct Find {
  double share = 0;
  std::uint64_t n = 0;

  auto members() { return std::tie(share, n); }
  /// Orders larger distances first; for equal distances, the first sample.
  friend bool operator<(const Find& a, const Find& b) { return a.share != b.share ? a.share > b.share : a.n < b.n; }
  friend bool operator==(const Find&, const Find&) = default;
};

/// The results of one method on random samples of one region.
struct Onset {
  static constexpr std::size_t kMostKept = 2;

  std::vector<std::uint64_t> wrong = std::vector<std::uint64_t>(kMostExponent + 1);  ///< [k]: samples wrong at 2^-k
  std::uint64_t samples = 0;
  std::vector<Find> furthest;  ///< the first ones

  auto members() { return std::tie(wrong, samples, furthest); }
  Onset& operator+=(const Onset& other);
};

/// The results of random samples for all regions and methods; sums do not depend on their order.
struct Onsets {
  std::vector<Onset> all;     ///< [region][method]
  std::uint64_t done = 0;     ///< samples per region
  std::uint64_t missing = 0;  ///< samples, over all regions, that were not found

  auto members() { return std::tie(all, done, missing); }
};

/// A case, found by climbing, about which a method is wrong far from the threshold.
struct Worst {
  double share = 0;          ///< distance from the threshold, as a share of the size; 0 if none was found
  std::uint64_t n = 0;       ///< of the sample from which the climb started
  std::int64_t doubles = 0;  ///< the same offset in doubles; negative: a smaller radius, or a smaller coordinate
  std::string line;          ///< the case as JSON; its `expected` has only the key that the method gets wrong

  auto members() { return std::tie(share, n, doubles, line); }
  friend bool operator==(const Worst&, const Worst&) = default;
};

/// The furthest case of each region and method; sums do not depend on their order.
struct WorstCases {
  std::vector<Worst> all;          ///< [region][method]
  std::uint64_t wrong_truths = 0;  ///< truths that `exact` did not confirm: a defect of this program

  WorstCases& operator+=(const WorstCases& other);
};

[[nodiscard]] inline std::uint64_t items_done(const Onsets& onsets) { return onsets.done; }

/// Returns empty onsets.
[[nodiscard]] Onsets no_onsets(const Settings& settings);

/// Measures how far from the threshold each method is wrong, for those of `samples` samples of every region that the
/// onsets do not contain yet, and adds them. Returns the number of samples that they then contain.
std::uint64_t run_onsets(const Settings& settings, std::uint64_t samples, const run::RunControl<Onsets>& course,
                         Onsets& onsets);

/// Climbs from the furthest samples of each region and method. The result is a function of settings and onsets,
/// independent of threads; `exact` confirms each case. Returns the number of climbs done, of climb_count(settings).
std::uint64_t run_climbs(const Settings& settings, const run::RunControl<WorstCases>& course, const Onsets& onsets,
                         WorstCases& worst);
[[nodiscard]] std::uint64_t climb_count(const Settings& settings);

}  // namespace touchstone::near_edge
