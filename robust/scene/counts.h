// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "../filtered/stage.h"

namespace touchstone::scene {

/// What settled a face for a question about a ball: for each face exactly one, the first that applies.
///
/// Slab to Touched are decided exactly: they depend on the ball and the face alone, but for Foot and Edges of polygons,
/// which depend on the polygon's own hierarchy too. For `nearest` the ball is the one about the centre that has shrunk
/// to little more than the distance of the nearest face met so far.
enum class CullOutcome {
  Box,      ///< never come to: some box of the object's hierarchy misses the ball
  Known,    ///< no box misses the ball, but the answer was known by then (`touches` alone)
  Slab,     ///< the ball does not reach the face's supporting plane
  Foot,     ///< it does, but no edge needed a look. Triangle: the foot is beyond the line of an edge, and the ball does
            ///< not reach that line. Polygon: the part of the plane in the ball meets no leaf of the edges' hierarchy,
            ///< and the foot is outside
  Edges,    ///< the foot is outside, and the edges that were looked at are out of the ball
  Touched,  ///< the ball touches the face; for `nearest` it was a candidate then
};
inline constexpr std::size_t kCullOutcomes = 6;  ///< how many there are

/// `box`, `known`, `slab`, `foot`, `edges`, `touched`.
[[nodiscard]] std::string_view word(CullOutcome outcome);

/// What became of the faces that one question, or several in sum, were about.
///
/// Guarantees
///  (1) every face asked about has one fate: the fates add up to `faces()`;
///  (2) every face that was tested (slab, foot, edges or touched) has one stage: the stages add up to `tested()`;
///  (3) the counts of several questions are the sum of each one's; answers are the same with and without counts;
///  (4) one machine gives the same counts each time. Machines with other vector instructions may differ in stages and,
///      within roundings, in boxes.
class FaceCounts {
 public:
  /// Faces that were asked about: all of the objects.
  [[nodiscard]] std::uint64_t faces() const;
  /// Those of one fate.
  [[nodiscard]] std::uint64_t faces(CullOutcome outcome) const { return outcomes_[static_cast<std::size_t>(outcome)]; }
  /// Faces about which the contact question was asked.
  [[nodiscard]] std::uint64_t tested() const { return faces() - faces(CullOutcome::Box) - faces(CullOutcome::Known); }
  /// Of these, those whose slowest stage was this one: later stages were never entered for them.
  [[nodiscard]] std::uint64_t tested(filtered::Stage slowest) const {
    return stages_[static_cast<std::size_t>(slowest)];
  }
  /// Edges of the faces that were asked about.
  [[nodiscard]] std::uint64_t edges() const { return edges_; }
  /// Edges whose distance from the ball was needed. Triangle: all three where the foot is outside, if neither slab nor
  /// foot settled it, else none (the first stage computes with all three either way). Polygon: those in the leaves of
  /// its hierarchy that were come to, all where only `exact` reaches.
  [[nodiscard]] std::uint64_t edges_looked_at() const { return edges_looked_at_; }

  /// Adds the counts of other questions.
  FaceCounts& operator+=(const FaceCounts& other);
  friend bool operator==(const FaceCounts&, const FaceCounts&) = default;

 private:
  friend class Tally;
  std::array<std::uint64_t, kCullOutcomes> outcomes_{};
  std::array<std::uint64_t, filtered::kStages> stages_{};
  std::uint64_t edges_ = 0, edges_looked_at_ = 0;
};

}  // namespace touchstone::scene
