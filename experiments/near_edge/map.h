// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/judge/comparison.h"
#include "experiments/run/sweep.h"

namespace touchstone::near_edge {

using judge::kTests;
using judge::Outcome;
using judge::Test;

/// What lies straight below the middle of a map: a point of an L.
enum class Spot {
  Face,          ///< inside, away from the edges
  Edge,          ///< the middle of an edge
  Vertex,        ///< where the region turns by less than 180 degrees
  ReflexVertex,  ///< where it turns by more
};

[[nodiscard]] std::string_view word(Spot spot);

/// The plane above a spot of an L, one pixel a double: the centre is moved double by double in the two coordinates that
/// are not dropped, both of one binade, so that pixels are square.
///
/// The middle is the double nearest to straight above the spot. The radius is the double nearest to the distance of
/// that centre, so that both the foot (but above the face) and the contact change within the map.
/// After Kettner, Mehlhorn, Pion, Schirra and Yap, "Classroom examples of robustness problems in geometric
/// computations".
struct Map {
  static constexpr int kSize = 96;  ///< pixels a side

  Spot spot = Spot::Face;
  double origin_distance = 0;  ///< of the polygon from the origin, in its sizes
  Test test = Test::Contact;   ///< Foot (not above the face, where it does not change) or Contact
  std::string truth;           ///< a letter a pixel, row by row: i(nside) b(oundary) o(utside), or c(ontact) n(one)
  std::vector<std::string> verdicts;  ///< of each method: = right, + wrongly in, - wrongly out, b boundary missed

  friend bool operator==(const Map&, const Map&) = default;
};

inline constexpr double kOriginDistances[] = {0, 1e3, 1e6};

/// A map of either test at each spot and distance; a function of (methods, seed) alone, at the first process; nothing
/// at the others. Those that are whole, where stopped. `progress` is told rows, of map_rows(). Cost: about 30 us a
/// pixel and four methods, so that nothing is kept of a run that was killed.
[[nodiscard]] std::vector<Map> draw_maps(const std::vector<const methods::Method*>& methods, std::uint64_t seed,
                                         unsigned threads, const run::Processes& processes,
                                         const std::atomic<bool>& stop, const run::Progress& progress);

[[nodiscard]] std::uint64_t map_rows();

}  // namespace touchstone::near_edge
