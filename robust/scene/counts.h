// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "../filtered/stage.h"

namespace touchstone::scene {

/// The test that settled a face in a query with a ball. Each face has exactly one outcome, the first that applies.
///
/// Slab to Touched are decided exactly and depend only on the ball and the face, except that Foot and Edges of a
/// polygon also depend on the polygon's own hierarchy. In `nearest` the ball is the one about the centre that has
/// shrunk to little more than the distance of the nearest face found so far.
///
/// A moving ball counts in the same way, at all times together: Slab if it stays on one side of the plane and never
/// reaches it, else Edges or Touched, but never Foot. In `first_contact` Box also covers faces in boxes that the ball
/// comes to later than to the first face found so far.
enum class CullOutcome {
  Box,      ///< not tested: some box of the object's hierarchy misses the ball
  Known,    ///< not tested: no box misses the ball, but the answer was already known (`touches` only)
  Slab,     ///< the ball does not reach the face's supporting plane
  Foot,     ///< the ball reaches the plane, but no edge had to be examined. Triangle: the foot is beyond the line of an
            ///< edge, and the ball does not reach that line. Polygon of more than 32 edges: the disc in which the ball
            ///< cuts the plane meets no leaf of the edges' hierarchy, and the foot is outside. All edges of a smaller
            ///< polygon are examined
  Edges,    ///< the foot is outside, and the ball misses every edge that was examined
  Touched,  ///< the ball touches the face; in `nearest` the face was a candidate at that time
};
inline constexpr std::size_t kCullOutcomes = 6;  ///< the number of outcomes

/// Returns `box`, `known`, `slab`, `foot`, `edges` or `touched`.
[[nodiscard]] std::string_view to_string(CullOutcome outcome);

/// The outcomes of all faces in one query, or in several queries together.
///
/// Guarantees
///  (1) every face in the query has one outcome: the outcomes add up to `faces()`;
///  (2) every face that was tested (Slab, Foot, Edges or Touched) has one stage: the stages add up to `tested()`;
///  (3) the counts of several queries are the sum of their counts; answers are the same with and without counts;
///  (4) the same machine returns the same counts each time. Machines with other vector instructions may differ in
///      stages and, within rounding errors, in boxes.
class FaceCounts {
 public:
  /// Returns the number of faces in the query: all faces of its objects.
  [[nodiscard]] std::uint64_t faces() const;
  /// Returns the number of faces with an outcome.
  [[nodiscard]] std::uint64_t faces(CullOutcome outcome) const { return outcomes_[static_cast<std::size_t>(outcome)]; }
  /// Returns the number of faces that were tested for contact.
  [[nodiscard]] std::uint64_t tested() const { return faces() - faces(CullOutcome::Box) - faces(CullOutcome::Known); }
  /// Returns the number of tested faces for which this was the slowest stage used.
  [[nodiscard]] std::uint64_t tested(filtered::Stage slowest) const {
    return stages_[static_cast<std::size_t>(slowest)];
  }
  /// Returns the number of edges of all faces in the query.
  [[nodiscard]] std::uint64_t edges() const { return edges_; }
  /// Returns the number of edges whose distance from the ball was needed. Triangle: all three if the foot is outside
  /// and neither Slab nor Foot settled it, else none (the first stage computes with all three either way). Polygon: the
  /// edges in the leaves of its hierarchy that were visited, or all edges if only `exact` can decide. Moving ball: the
  /// edges of a triangle, and those in the leaves of a polygon that the ball may reach, unless Slab settled the face.
  [[nodiscard]] std::uint64_t edges_looked_at() const { return edges_looked_at_; }

  /// Adds the counts of other queries.
  FaceCounts& operator+=(const FaceCounts& other);
  friend bool operator==(const FaceCounts&, const FaceCounts&) = default;

 private:
  friend class Tally;
  std::array<std::uint64_t, kCullOutcomes> outcomes_{};
  std::array<std::uint64_t, filtered::kStages> stages_{};
  std::uint64_t edges_ = 0, edges_looked_at_ = 0;
};

}  // namespace touchstone::scene
