// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/comparison.h"
#include "experiments/cases/method.h"
#include "experiments/cases/workloads/workload.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::cases {

/// The threshold across which a ball is moved, one double after the other.
enum class Threshold {
  Face,        ///< moves the radius across the distance to the polygon, whose nearest feature is the face
  Edge,        ///< the same, nearest feature an edge
  Vertex,      ///< the same, nearest feature a vertex
  Tangent,     ///< the same, for a distance that is exactly a double; any nearest feature
  FootEdge,    ///< moves the centre along an axis so that its foot crosses an edge; ample radius
  FootVertex,  ///< the same, the foot passing a vertex
};

[[nodiscard]] std::string_view to_string(Threshold threshold);
/// Returns whether the radius is moved (otherwise the centre).
[[nodiscard]] bool moves_radius(Threshold threshold);
/// Returns the decision that changes there: the final answer if the radius is moved, the foot if the centre is.
[[nodiscard]] Test test_at(Threshold threshold);

/// A stratum of the samples: each is sampled separately.
struct Stratum {
  workloads::Family family;
  workloads::Placement placement;
  Threshold threshold;
};

/// Returns all strata. Exactly tangent balls exist only on the lattice.
[[nodiscard]] const std::vector<Stratum>& all_strata();
[[nodiscard]] const std::vector<Threshold>& all_thresholds();

/// Returns the offsets by which balls are moved, in doubles, ascending: every integer from -8 to 8, then powers of 4 up
/// to 2^32.
[[nodiscard]] const std::vector<std::int64_t>& all_offsets();

/// The properties of polygons besides their stratum.
struct Shape {
  std::size_t vertices = 24;   ///< as close to this number as the family allows
  std::size_t holes = 0;       ///< of each polygon; samples without room for them are missing
  double origin_distance = 0;  ///< of each polygon from the origin, in multiples of its size

  friend bool operator==(const Shape&, const Shape&) = default;
};

/// The coordinates of a sample: it is a function of them alone.
struct SamplePlace {
  std::size_t stratum;
  Shape shape;
  std::uint64_t seed;
  std::uint64_t n;
};

/// Returns the name of a sample, which holds all that is needed to draw it again.
[[nodiscard]] std::string id(const SamplePlace& place);

/// A polygon and balls across a threshold: one ball for each offset.
///
/// Radius: offset 0 is the double nearest to the exact distance; positive offsets are larger radii.
/// Foot: offset 0 is the last centre whose foot is not outside; for offset 1, the next double, the foot is outside.
struct Crossing {
  Polygon polygon;
  std::vector<Ball> balls;
  std::vector<cases::PartialAnswer> truths;  ///< for each ball: plane, foot, edges_hit, contact
};

/// Draws the sample at that place. `truth` must be a correct method (`exact` or `filtered`; both give the same bits).
/// Returns nothing if no such sample was found.
[[nodiscard]] std::optional<Crossing> draw_crossing(const SamplePlace& place, const cases::Method& truth);

/// The point where a foot leaves the polygon: not outside at `last`, outside one double further.
struct FootCrossing {
  Ball last;
  std::int64_t outward;  ///< 1 or -1: the direction of doubles in which the foot leaves
};

/// Searches for a crossing within `reach` doubles of a ball whose centre moves along an axis: first at powers of two on
/// both sides, then by bisection. Returns nothing if the foot does not change at the powers of two, or if the
/// coordinate is almost zero.
[[nodiscard]] std::optional<FootCrossing> find_foot_crossing(const Ball& ball, int axis, std::int64_t reach,
                                                             const std::function<bool(const Ball&)>& is_outside);

/// Returns the answers of a correct method to one query about each ball of a crossing whose radius is moved. Uses that
/// answers are monotonic: two radii with the same answer have it in between, too.
[[nodiscard]] std::vector<cases::PartialAnswer> ask_growing(const std::vector<Ball>& balls, cases::QueryKind kind,
                                                            const cases::PreparedMethod& oracle);

}  // namespace touchstone::cases
