// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/program/sweep.h"
#include "experiments/studies/near_edge/measure.h"

namespace touchstone::near_edge {

/// The subject of a map: a point of an L.
enum class Spot {
  Face,          ///< inside, away from the edges
  Edge,          ///< the middle of an edge
  Vertex,        ///< a corner with an interior angle of less than 180 degrees
  ReflexVertex,  ///< a corner with a larger one
};

[[nodiscard]] std::string_view to_string(Spot spot);

/// A map of a plane around a spot of an L, with one pixel per double: the centre moves double by double in the two
/// coordinates that are not dropped, both of one binade, so that pixels are square.
///
/// Foot: the middle of the map is the double nearest to the point straight above the spot, so that the foot leaves the
/// polygon there. Contact: the spot's feature is the nearest one at the middle, and the radius is the double nearest to
/// its distance, so that contact changes there. For the face, the middle is straight above the spot; for an edge and a
/// vertex, it is as far outside, in the L's plane, as above that plane. A reflex vertex is the nearest feature only of
/// centres straight above it and their opposites; all their neighbours are nearer to the face or an edge. So its map
/// shows the notch: above the bisector, where the two edges that end at the vertex are equally near, and the ball
/// changes from touching one to touching the other.
///
/// After Kettner, Mehlhorn, Pion, Schirra and Yap, "Classroom examples of robustness problems in geometric
/// computations".
struct Map {
  static constexpr int kSize = 96;  ///< pixels per side

  Spot spot = Spot::Face;
  double origin_distance = 0;  ///< of the polygon from the origin, in multiples of its size
  Test test = Test::Contact;   ///< Foot (not of the face, where it does not change) or Contact
  std::string truth;           ///< one letter per pixel, row by row: i(nside) b(oundary) o(utside), or c(ontact) n(one)
  std::vector<std::string> verdicts;  ///< for each method: = right, + wrongly in, - wrongly out, b boundary missed

  friend bool operator==(const Map&, const Map&) = default;
};

inline constexpr double kOriginDistances[] = {0, 1e3, 1e6};

/// Draws a map of either test at each spot and distance, a function of (methods, seed) alone. If stopped, returns the
/// completed maps. `progress` receives the number of rows done, of map_rows(). Cost: about 30 us per pixel and four
/// methods.
[[nodiscard]] std::vector<Map> draw_maps(const std::vector<const cases::Method*>& methods, std::uint64_t seed,
                                         unsigned threads, const std::atomic<bool>& stop,
                                         const program::Progress& progress);

[[nodiscard]] std::uint64_t map_rows();

/// Writes a table a map. Throws as write_failures does.
void write_maps(const std::filesystem::path& folder, const Settings& settings, const std::vector<Map>& maps);

}  // namespace touchstone::near_edge
