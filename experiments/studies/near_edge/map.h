// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/cases/comparison.h"
#include "experiments/harness/sweep.h"

namespace touchstone::near_edge {

using cases::kTests;
using cases::Outcome;
using cases::Test;

/// What a map is about: a point of an L.
enum class Spot {
  Face,          ///< inside, away from the edges
  Edge,          ///< the middle of an edge
  Vertex,        ///< where the region turns by less than 180 degrees
  ReflexVertex,  ///< where it turns by more
};

[[nodiscard]] std::string_view word(Spot spot);

/// A plane about a spot of an L, one pixel a double: the centre is moved double by double in the two coordinates that
/// are not dropped, both of one binade, so that pixels are square.
///
/// Foot: the middle is the double nearest to straight above the spot, so that the foot leaves the polygon there.
/// Contact: the spot's feature is the nearest of the middle, and the radius is the double nearest to its distance, so
/// that the contact changes there: for the face straight above it; for an edge and a vertex as far out beyond them,
/// in the L's plane, as above that. A reflex vertex is the nearest feature of no centre but those straight above it
/// and their opposites, all neighbours of which are nearer to the face or an edge. What is drawn of it is the notch:
/// above its bisector, where the two edges that end at the vertex are equally near, and which of them the ball touches
/// changes.
///
/// After Kettner, Mehlhorn, Pion, Schirra and Yap, "Classroom examples of robustness problems in geometric
/// computations".
struct Map {
  static constexpr int kSize = 96;  ///< pixels a side

  Spot spot = Spot::Face;
  double origin_distance = 0;  ///< of the polygon from the origin, in its sizes
  Test test = Test::Contact;   ///< Foot (not of the face, where it does not change) or Contact
  std::string truth;           ///< a letter a pixel, row by row: i(nside) b(oundary) o(utside), or c(ontact) n(one)
  std::vector<std::string> verdicts;  ///< of each method: = right, + wrongly in, - wrongly out, b boundary missed

  auto members() { return std::tie(truth, verdicts); }
  friend bool operator==(const Map&, const Map&) = default;
};

inline constexpr double kOriginDistances[] = {0, 1e3, 1e6};

/// A map of either test at each spot and distance; a function of (methods, seed) alone, at the first process; nothing
/// at the others. Those that are whole, where stopped. `progress` is told rows, of map_rows(). Cost: about 30 us a
/// pixel and four methods, so that nothing is kept of a run that was killed.
[[nodiscard]] std::vector<Map> draw_maps(const std::vector<const cases::Method*>& methods, std::uint64_t seed,
                                         unsigned threads, const harness::Processes& processes,
                                         const std::atomic<bool>& stop, const harness::Progress& progress);

[[nodiscard]] std::uint64_t map_rows();

}  // namespace touchstone::near_edge
