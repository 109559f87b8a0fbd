// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/run/blocks.h"
#include "experiments/judge/comparison.h"

namespace touchstone::near_edge {

using judge::kTests;
using judge::Outcome;
using judge::Test;

/// The plane above the reflex vertex of an L, one pixel a double: the centre is moved double by double in the two
/// coordinates that are not dropped, both of one binade, so that pixels are square.
///
/// The middle is the double nearest to straight above the vertex. The radius is the double nearest to the distance of
/// that centre, so that both the foot and the contact change within the map.
/// After Kettner, Mehlhorn, Pion, Schirra and Yap, "Classroom examples of robustness problems in geometric
/// computations".
struct Map {
  static constexpr int kSize = 96;  ///< pixels a side

  double origin_distance;  ///< of the polygon from the origin, in its sizes
  Test test;               ///< Foot or Contact
  std::string truth;       ///< a letter a pixel, row by row: i(nside) b(oundary) o(utside), or c(ontact) n(one)
  std::vector<std::string> verdicts;  ///< of each method: = right, + wrongly in, - wrongly out, b boundary missed
};

inline constexpr double kOriginDistances[] = {0, 1e3, 1e6};

/// A map of either test at each distance; a function of (methods, seed) alone. Fewer where stopped.
[[nodiscard]] std::vector<Map> draw_maps(const std::vector<const methods::Method*>& methods, std::uint64_t seed,
                                         unsigned threads, const std::atomic<bool>& stop, const run::Progress& progress);

/// The number of blocks that `draw_maps` reports.
[[nodiscard]] std::uint64_t map_blocks();

}  // namespace touchstone::near_edge
