// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "../../geometry/contact/first_contact.h"
#include "../../geometry/shapes/motion.h"
#include "../../geometry/shapes/triangle.h"
#include "filtered.h"

/// Moving balls: the answers of exact/motion.h at about the price of `fast`.
///
/// Floating-point state, flags, threads and allocations are as in filtered.h. Events are found in doubles that carry
/// their own error, then in double-doubles; `time`, `point` and `contact_normal` are rounded from these if that is
/// certain. What remains open goes to `exact`.
///
/// Guarantees, for every motion and every polygon or triangle that `find_fault` and `exact::validate` accept:
///  (1) each answer equals that of the function of the same name in `exact`;
///  (2) a batch returns the answers of single queries, in the same order;
///  (3) the answers are the same with and without vector instructions; only stages and times differ.
/// Bounds: robust/filtered/detail/numbers/bounded.h.
namespace touchstone::filtered {

/// @{
/// Returns whether the ball touches at any time. This is the contact of the capsule, too. Cost: constant for a
/// triangle; for a polygon that of the edges near the way. `counts` also receives which stages decided.
[[nodiscard]] bool contact(const Motion& motion, const PreparedPolygon& polygon);
[[nodiscard]] bool contact(const Motion& motion, const PreparedPolygon& polygon, StageCounts& counts);
[[nodiscard]] bool contact(const Motion& motion, const Polygon& polygon);
[[nodiscard]] bool contact(const Motion& motion, const Triangle& triangle);
[[nodiscard]] bool contact(const Motion& motion, const Triangle& triangle, StageCounts& counts);
/// @}

/// @{
/// Returns the first contact. `time`, `depth` and each coordinate of `point` and of `contact_normal` are the doubles
/// nearest to the exact numbers.
[[nodiscard]] FirstContact first_contact(const Motion& motion, const PreparedPolygon& polygon);
[[nodiscard]] FirstContact first_contact(const Motion& motion, const PreparedPolygon& polygon, StageCounts& counts);
[[nodiscard]] FirstContact first_contact(const Motion& motion, const Polygon& polygon);
[[nodiscard]] FirstContact first_contact(const Motion& motion, const Triangle& triangle);
[[nodiscard]] FirstContact first_contact(const Motion& motion, const Triangle& triangle, StageCounts& counts);
/// @}

/// @{
/// Returns which of two polygons or triangles the ball touches first: the first (-1), both at the same time or neither
/// (0), or the second (+1). Compares the exact times.
[[nodiscard]] int compare_times(const Motion& motion, const PreparedPolygon& first, const PreparedPolygon& second);
[[nodiscard]] int compare_times(const Motion& motion, const Triangle& first, const Triangle& second);
/// @}

/// Writes to touches[i] whether motions[i] touches the polygon. Throws std::invalid_argument if the spans differ in
/// length.
void contact(std::span<const Motion> motions, const PreparedPolygon& polygon, std::span<bool> touches);
/// Writes to touches[i] whether the moving ball touches triangles[i]. Throws std::invalid_argument if the spans differ
/// in length.
void contact(const Motion& motion, std::span<const Triangle> triangles, std::span<bool> touches);

}  // namespace touchstone::filtered
