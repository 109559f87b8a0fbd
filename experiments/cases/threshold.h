// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/workloads/workload.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::cases {

/// What a ball is moved across, double by double.
enum class Threshold {
  Face,        ///< the radius across the distance to the polygon, the nearest feature being its face
  Edge,        ///< the same, an edge
  Vertex,      ///< the same, a vertex
  Tangent,     ///< the same, where that distance is exactly a double; the nearest feature is any
  FootEdge,    ///< the centre, along one axis, so that its foot crosses an edge; ample radius
  FootVertex,  ///< the same, past a vertex
};

[[nodiscard]] std::string_view word(Threshold threshold);
/// Is the radius moved (else the centre)?
[[nodiscard]] bool moves_radius(Threshold threshold);

/// What is sampled apart from the rest.
struct Stratum {
  workloads::Family family;
  workloads::Placement placement;
  Threshold threshold;
};

/// All of them; exactly tangent balls need the lattice.
[[nodiscard]] const std::vector<Stratum>& all_strata();
[[nodiscard]] const std::vector<Threshold>& all_thresholds();

/// How far balls are moved, in doubles, ascending: every double from -8 to 8, then powers of 4 up to 2^32.
[[nodiscard]] const std::vector<std::int64_t>& all_offsets();

/// What polygons have in common besides their stratum.
struct Shape {
  std::size_t vertices = 24;   ///< as near as the family allows
  std::size_t holes = 0;       ///< of each polygon; what has no room for them is missing
  double origin_distance = 0;  ///< of each polygon from the origin, in its sizes

  friend bool operator==(const Shape&, const Shape&) = default;
};

/// Where a sample is drawn: everything that it is a function of.
struct SamplePlace {
  std::size_t stratum;
  Shape shape;
  std::uint64_t seed;
  std::uint64_t n;
};

/// The name of a sample: names all that is needed to draw it again.
[[nodiscard]] std::string id(const SamplePlace& place);

/// A polygon, and balls across a threshold: one an offset.
///
/// Radius: offset 0 is the double nearest to the exact distance, larger radii are positive.
/// Foot: offset 0 is the last centre whose foot is not outside; offset 1, the next double, is outside.
struct Crossing {
  Polygon polygon;
  std::vector<Ball> balls;
  std::vector<cases::PartialAnswer> truths;  ///< of each ball: plane, foot, edges_hit, contact
};

/// The sample of that place, with the truth by a method that is right (`exact` or `filtered`: the same bits). Nothing
/// where none was found.
[[nodiscard]] std::optional<Crossing> draw_crossing(const SamplePlace& place, const cases::Method& truth);

/// Where a foot leaves the polygon: not outside at `last`, outside one double further.
struct FootCrossing {
  Ball last;
  std::int64_t outward;  ///< 1 or -1: the direction of doubles in which the foot leaves
};

/// Looks for one at most `reach` doubles from a ball, its centre moved along an axis: at powers of two to either side,
/// then by bisection. Nothing where the foot does not change at those, or the coordinate is almost zero.
[[nodiscard]] std::optional<FootCrossing> find_foot_crossing(const Ball& ball, int axis, std::int64_t reach,
                                                             const std::function<bool(const Ball&)>& is_outside);

/// What one question has for answers about the balls of a crossing whose radius is moved, by a method that is right:
/// answers do not change between two radii with the same one.
[[nodiscard]] std::vector<cases::PartialAnswer> ask_growing(const std::vector<Ball>& balls, cases::Question question,
                                                            const cases::PreparedMethod& oracle);

}  // namespace touchstone::cases
