// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "experiments/cases/case.h"
#include "experiments/cases/key.h"

// Answers that are wrong, but right about a ball of nearly this radius: what an engine that rounds can be held to.
namespace touchstone::cases {

/// A length, by which the radius may be changed before an answer is right.
struct Margin {
  double number = 0;
  bool of_size = true;  ///< in sizes of the case, else in its unit of length

  /// Returns the length for a case, rounded to the nearest double. The *size* of a case is the largest magnitude of its
  /// coordinates, those of a mesh as its pose has them, and its radius.
  [[nodiscard]] double length(const AnyShapes& shapes) const;
};

/// Returns the margin of a text: `2^-20` and `1e-6` are in sizes of the case, `2^-20m` and `1e-6m` in its unit of
/// length. Throws std::invalid_argument, which says why, for another text, and if the number is not finite or not above
/// 0.
[[nodiscard]] Margin margin_of(const std::string& text);

/// The exact answers to a question with the radius as it is and off by a margin to either side. The smaller radius is 0
/// at least, the larger one a finite double; both are rounded to the nearest double.
class AnswersWithin {
 public:
  AnswersWithin(AnyShapes shapes, double margin);

  /// Returns whether the expected value of this key is the exact one. Another one cannot have a margin.
  [[nodiscard]] bool is_exact(const Key& key, const StatedAnswer& expected) const;
  /// Returns whether the value of this key in an answer is within the margin:
  ///  (1) if it is that of the question with one of the three radii;
  ///  (2) `relation`, `first`, `time`: if it is between those of the outer radii; `plane_tangent`: if `plane` differs
  ///      between these; `momentary`: if it differs among the three; `edges_hit`: if it has the edges that the smallest
  ///      ball hits, and no edge that the largest misses;
  ///  (3) `distance`, `depth`, `off_plane`: if it is off by the margin at most; a `depth` for a moving ball that does
  ///      not touch, if it is off by as much from that of the largest;
  ///  (4) `point`: if a ball around it with the margin as its radius touches the polygon, and it is no farther from the
  ///      centre than the closest point, by more than the margin. For a moving ball the centre may be anywhere between
  ///      the first contacts of the outer radii, and the closest point is at the radius, unless the ball touches at its
  ///      start;
  ///  (5) `contact_normal`: if its length is off 1 by the margin in sizes of the case at most, and the point at that
  ///      distance against its direction, from such a centre, is within the margin of the polygon;
  ///  (6) `foot`: if the foot, rounded to doubles, is within the margin of the boundary;
  ///  (7) `nearest`: if the distance to that feature exceeds the least by the margin at most;
  ///  (8) `touched`: if it has the faces that the smallest ball touches, and no face that the largest does not;
  ///  (9) `face`: if its distance, rounded, exceeds the least by the margin at most, or if a moving ball touches it
  ///      with the largest radius no later than any face with the smallest.
  ///
  /// Of a mesh, (4) to (7), `momentary` and the depth of a moving ball are about the face that the answer names, if (9)
  /// holds for that, and else about the right one. Distances of (4), (5) and (7) are computed in doubles. A key that
  /// the answer lacks, or whose value does not have the form of the contract, is not within it.
  [[nodiscard]] bool has(const Key& key, const StatedAnswer& answer) const;

 private:
  [[nodiscard]] const PartialAnswer& smallest() const { return answers_[0]; }
  [[nodiscard]] const PartialAnswer& truth() const { return answers_[1]; }
  [[nodiscard]] const PartialAnswer& largest() const { return answers_[2]; }

  [[nodiscard]] const Polygon& polygon() const { return std::get<Shapes>(shapes_).polygon; }
  [[nodiscard]] const Motion* motion() const { return std::get_if<Motion>(&question_of(shapes_)); }
  [[nodiscard]] const Ball& ball() const { return ball_of(question_of(shapes_)); }
  [[nodiscard]] double larger_radius() const;
  [[nodiscard]] bool is_between(const Key& key, const PartialAnswer& found) const;
  /// The same for the keys that say something else of a mesh than of a polygon; nothing for the others.
  [[nodiscard]] std::optional<bool> is_between_of_mesh(const Key& key, const PartialAnswer& found) const;
  [[nodiscard]] bool has_face(std::size_t face) const;
  [[nodiscard]] bool has_point(const Eigen::Vector3d& point) const;
  [[nodiscard]] bool has_normal(const Eigen::Vector3d& normal) const;
  [[nodiscard]] bool has_feature(const Feature& feature) const;
  [[nodiscard]] bool foot_is_near_boundary() const;
  [[nodiscard]] bool reaches(const Motion& motion) const;
  /// Returns the exact distance of the centre at that time or place, rounded.
  [[nodiscard]] double distance() const;
  /// Returns where the centre may be: its place, or the ends of the part of its way between the first contacts.
  [[nodiscard]] std::array<Eigen::Vector3d, 2> centers() const;

  AnyShapes shapes_;
  double margin_, size_;                  ///< `size_`: that of the case
  std::array<PartialAnswer, 3> answers_;  ///< by radius, ascending
};

}  // namespace touchstone::cases
