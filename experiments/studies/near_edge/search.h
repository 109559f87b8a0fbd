// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "experiments/studies/near_edge/measure.h"

namespace touchstone::near_edge {

/// A ball at a threshold, exactly except for rounding, and the direction in which it is moved.
struct AtThreshold {
  Polygon polygon;
  Ball ball;       ///< radius: the double nearest to the distance; foot: the last centre whose foot is not outside
  int moved_axis;  ///< of the centre; none (-1) if the radius is moved

  [[nodiscard]] Test test() const { return moved_axis < 0 ? Test::Contact : Test::Foot; }
  /// Returns the largest coordinate difference of two vertices, to which offsets are relative.
  [[nodiscard]] double size() const;
  /// Returns the ball moved by that share of the size, rounded to doubles; nothing if the radius would be negative.
  [[nodiscard]] std::optional<Ball> moved(double share) const;
  /// Returns the share of the size by which a ball is moved.
  [[nodiscard]] double share_of(const Ball& ball) const;
};

/// Returns the ball of offset 0 of a sample, or nothing if none was found.
[[nodiscard]] std::optional<AtThreshold> draw_at_threshold(const cases::SamplePlace& place);

/// Balls are moved by 2^-k of the size, k = 0, ..., kMostExponent, to either side.
inline constexpr std::size_t kMostExponent = 60;

/// The distance from a threshold up to which a method was seen to be wrong: by the contract, and about the polygon as
/// given, so that it is no matter of lifted vertices.
struct WrongReach {
  std::array<bool, kMostExponent + 1>
      wrong{};                   ///< [k]: whether at 2^-k, on either side; false if that is less than a double.
  std::optional<Ball> furthest;  ///< the furthest ball on which it was seen to be wrong
  double share = 0;              ///< by which it is moved, as a share of the size

  friend bool operator<(const WrongReach& a, const WrongReach& b) { return a.share < b.share; }
};

/// Tests at 2^-k of the size to either side, for every k, then at kSteps even steps between the largest offset found
/// wrong and twice that.
///
/// Wrong answers need not end at one offset, and a sweep of all doubles is not affordable. So the result only states
/// that the method is wrong at `furthest` and was right at every tested ball further out. `truth` must be a correct
/// method, prepared for the same polygon.
[[nodiscard]] WrongReach wrong_reach(const AtThreshold& at, const cases::PreparedMethod& method, bool knows_boundary,
                                     const cases::PreparedMethod& truth);
inline constexpr int kSteps = 64;

inline constexpr int kClimbSteps = 64;

/// A case and the distance from its threshold at which the method is wrong about it.
struct Climbed {
  AtThreshold at;
  WrongReach reach;
};

/// Takes kClimbSteps steps. Each step moves one coordinate of a vertex or the centre, by some doubles or by one of its
/// lower 32 bits, and keeps the change if the method is wrong at least as far from the threshold. A change that yields
/// an invalid polygon or another kind of nearest feature is discarded. If the threshold moves the radius, the radius is
/// set to the new distance; if it moves the foot, the threshold is searched again along the same axis. At the origin
/// shapes hardly change; 10^6 sizes away, where a double is 2^-33 of the size, they do.
///
/// A function of its arguments. Cost: about 10 ms.
[[nodiscard]] Climbed climb(AtThreshold start, const cases::Method& method, workloads::Random random);

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
  double share = 0;     ///< distance from the threshold, as a share of the size; 0 if none was found
  std::uint64_t n = 0;  ///< of the sample from which the climb started
  std::string line;     ///< the case as JSON; its `expected` has only the key that the method gets wrong

  friend bool operator==(const Worst&, const Worst&) = default;
};

/// The furthest case of each region and method.
struct WorstCases {
  std::vector<Worst> all;          ///< [region][method]
  std::uint64_t wrong_truths = 0;  ///< truths that `exact` did not confirm: a defect of this program
};

[[nodiscard]] inline std::uint64_t items_done(const Onsets& onsets) { return onsets.done; }

/// Returns empty onsets.
[[nodiscard]] Onsets no_onsets(const Settings& settings);

/// Measures how far from the threshold each method is wrong, for those of `samples` samples of every region that the
/// onsets do not contain yet, and adds them.
void run_onsets(const Settings& settings, std::uint64_t samples, const program::RunControl& control, Onsets& onsets);
/// Climbs from the furthest samples of each region and method, in climb_count(settings) climbs. The result is a
/// function of settings and onsets, independent of threads; `exact` confirms each case.
[[nodiscard]] WorstCases run_climbs(const Settings& settings, const program::RunControl& control, const Onsets& onsets);
[[nodiscard]] std::uint64_t climb_count(const Settings& settings);

// Results only, and errors, as of write_failures.

void write_onsets(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets);
/// Also writes worst.jsonl: these cases, for `touchstone judge`.
void write_worst(const std::filesystem::path& folder, const Settings& settings, const Onsets& onsets,
                 const WorstCases& worst);
/// Returns what these tables hold.
[[nodiscard]] std::vector<program::TableDescription> search_tables();

/// Returns the table of the furthest answers for the terminal: over all families.
[[nodiscard]] std::string search_table(const Settings& settings, const Onsets& onsets, const WorstCases& worst);

}  // namespace touchstone::near_edge
