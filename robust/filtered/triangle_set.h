// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "../../geometry/shapes/ball.h"
#include "../../geometry/shapes/triangle.h"
#include "stage.h"

namespace touchstone::filtered {

/// Triangles prepared for questions about one ball and all of them.
///
/// A query evaluates eight triangles at once, in floats with a proved error bound, and asks `contact(ball, triangle)`
/// about those that floats leave open: triangles whose distance differs from the radius by less than about 2^-15 of the
/// group's radius and 2^-17 of the ball's, and few others. A group is eight triangles that follow each other in the
/// given order. A ball that is far from all of them, or around all of them, costs 1 ns for each. So neighbours should
/// follow each other, as they do in most meshes.
///
/// Guarantees, besides those of filtered.h:
///  (1) each answer equals that of `contact(ball, triangle)`, for every finite ball and every valid triangle;
///  (2) queries may run on several threads at once.
///
/// Cost: about 0.1 us per triangle to prepare it. A query takes about 3 ns per triangle with AVX2, 6 ns without.
/// Undecided triangles cost a single query plus 4 ns; so do all triangles of groups smaller than 2^-900, larger than
/// 2^500 or farther than 2^1000 from 0. Memory: 96 bytes per triangle, of which most queries read
/// 24.
class TriangleSet {
 public:
  /// Prepares the triangles. Throws Rejected, with the code of `exact::validate` and a message that names the
  /// triangle, for the first triangle that is not a valid polygon; of those that are taken as segments, for the first
  /// that is not finite.
  explicit TriangleSet(std::span<const Triangle> triangles, Degenerate degenerate = Degenerate::Refuse);
  /// @{
  /// A moved-from object may only be assigned to or destroyed.
  TriangleSet(TriangleSet&&) noexcept;
  TriangleSet& operator=(TriangleSet&&) noexcept;
  /// @}
  ~TriangleSet();

  /// Returns the number of triangles.
  [[nodiscard]] std::size_t size() const;
  /// Returns the triangles as they were given.
  [[nodiscard]] std::span<const Triangle> triangles() const;

  struct Parts;  ///< internal

 private:
  friend const Parts& parts_of(const TriangleSet& set);
  std::unique_ptr<const Parts> parts_;
};

/// @{
/// Writes to touches[i] whether the ball touches triangle i. Throws std::invalid_argument if `touches` does not have
/// one element for each triangle. `counts` also receives which stages decided: `Double` counts the triangles that
/// needed no later stage, whether floats or doubles decided them.
void contact(const Ball& ball, const TriangleSet& set, std::span<bool> touches);
void contact(const Ball& ball, const TriangleSet& set, std::span<bool> touches, StageCounts& counts);
/// @}

/// @{
/// Returns whether the ball touches at least one of the triangles. Stops at the first group with one.
[[nodiscard]] bool any_contact(const Ball& ball, const TriangleSet& set);
[[nodiscard]] bool any_contact(const Ball& ball, const TriangleSet& set, StageCounts& counts);
/// @}

/// @{
/// Returns the numbers of the triangles that the ball touches, ascending.
[[nodiscard]] std::vector<std::size_t> triangles_hit(const Ball& ball, const TriangleSet& set);
[[nodiscard]] std::vector<std::size_t> triangles_hit(const Ball& ball, const TriangleSet& set, StageCounts& counts);
/// @}

}  // namespace touchstone::filtered
