// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fast.h"
#include "fast_triangle.h"

/// How far off contact `fast` may be wrong.
///
/// u = 2^-53; size: the largest extent of the vertices along a coordinate axis; d: the exact distance of the centre;
/// S = size + d; N: the exact normal. For a triangle kappa is the square of its longest edge over |N|, that is its
/// longest edge over its least altitude. For a polygon it is P / |N|, where P sums |p(i)| |p(i+1)| in the maximum norm
/// over the n vertices of the outer loop, as seen from the first of them: about 1 for a star, large for slivers and for
/// outlines that fill little of their box. Holes do not count.
///
/// Theorem. Where no result underflows or overflows, `fast::contact` is right, for the polygon of the contract, if
///   | r - d | > (kTriangle kappa + kTriangleSize) u S, for a triangle with kappa <= kMostSlender;
///   | r - d | > (kPolygon (n + 1) kappa + kPolygonSize) u S, for a polygon whose loops lie in one plane exactly and for
///     which that factor of S is at most kMostShare;
///   | r - d | > kEdge u S, for a triangle whose foot is farther from it than kappa times its bound above.
/// Loops that are off their plane by rounding, but that `fast` does not lift: add kOffPlane times the `off_plane` of
/// `exact`. Of lifted loops nothing is said. The distance from the origin does not matter: differences of given numbers
/// come first. `distance` of `fast::answer` is as near to d as this.
///
/// Proof. The calculus proves (a) to (f) over the compiled templates, ratios the roundings of squares and quotients
/// (tests/robust/proofs/fast_error_test.cpp, which adds them up as below); the geometry is by hand. They find kMoment = 8,
/// kAlong = 14, kNormal(n) = 2 n + 2, kHeight = 11 and kSide = 40. No vertex is farther from the centre than S along an
/// axis, or sqrt 3 S.
///  (1) Vertices: |c - p|^2 and r^2 have relative errors of 5 and 1 u, so they are compared right beyond 3 u S.
///  (2) Edges: (a) a moment (c - p) x e is known to kMoment u S |e|, so the line's distance to sqrt 3 kMoment u S, and
///      squares, products and the root of `distance` add 5.5 u d. (b) (c - p).e is known to kAlong u S |e|, |e|^2 to
///      5 u |e|^2: where the foot is misjudged to be on the edge, or not to be, the end is at most kAlong u S + 5 u |e|
///      farther from it. kEdge is the sum.
///  (3) Plane: (c) N is known to kNormal(n) u P in each component, so its direction to an angle of at most
///      sqrt 3 kNormal u kappa. The foot and the vertex from which the height is measured are at most sqrt 3 S apart. So
///      the height is known to (3 kNormal kappa + kHeight) u S, and squares add 3 u d.
///  (4) Foot of a polygon: besides the height, the turn of the normal and 5 roundings move it by at most (sqrt 3 kNormal
///      kappa + 5) u d, all vertices alike; (d) differences part them by 3 u S more. The ends of an edge are seen at the
///      same places as those of its neighbours: what is counted are the crossings of a closed loop, whose parity changes
///      only where an edge passes the foot. An edge with both ends left or both right of the foot is judged by that; the
///      foot is in the box of any other that the ray may cross, where the distances from the edge and from its line are
///      the same. With (e), the error of the product that judges it, the foot is misjudged at most
///      sqrt 3 ((3 + sqrt 3) kNormal kappa + kHeight + 5 + 9 sqrt 2 + 6) u S from an edge (sqrt 3: it is projected).
///  (5) Foot of a triangle: (f) N.(moment) is known to kSide u S |e| |N|, so the distance from a line to kSide u S and
///      the angle of (3) times the distance of the centre from that line, which is nearly that from the plane. A foot
///      that is called inside is thus at most 2 kappa times as far from the triangle, beyond its sharpest corner;
///      kappa <= kMostSlender makes what grows with kappa^2 less than kappa / 5: it is perpendicular to the height.
///  (6) Contact is wrong only if a feature is misjudged, or the foot: if it is t from an edge, the distances of plane and
///      edge differ by at most t. So (4) or (5), and (3) or (2), add up to the theorem.
///  (7) The lift along an axis moves edges and plane by at most `off_plane` each, and what is seen from the foot by at
///      most twice that, sqrt 3 times as far in the plane: 1 + 2 sqrt 3 in all.
namespace touchstone::fast::error {

inline constexpr double kTriangle = 105, kTriangleSize = 15;
inline constexpr double kMostSlender = 0x1p14;
inline constexpr double kPolygon = 22.5, kPolygonSize = 103;
inline constexpr double kMostShare = 0x1p-12;
inline constexpr double kEdge = 43;
inline constexpr double kOffPlane = 5;

}  // namespace touchstone::fast::error

namespace touchstone::fast {

/// @{
/// Returns a length with this guarantee: if r differs by more from the exact distance, `contact` is right. The theorem's
/// bound, with r for d. Infinite where the theorem says nothing. Requires loops that lie in one plane exactly, as those
/// of triangles do. Call it in the default state of the floating-point unit. Cost: linear.
[[nodiscard]] double contact_error(const Ball& ball, const Triangle& triangle);
[[nodiscard]] double contact_error(const Ball& ball, const PreparedPolygon<double>& polygon);
/// @}

}  // namespace touchstone::fast
