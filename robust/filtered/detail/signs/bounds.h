// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The error bounds of the filters. robust/proofs/CLAIMS.md lists how each is proved, and which are counted by hand.
///
/// Model: every operation returns its exact result times (1 + d), |d| <= unit, plus at most 2^-1021 in magnitude
/// (underflow, flushed to zero or not). The model holds for doubles in every rounding direction with `kUnit`, for fused
/// and unfused products alike, and for double-doubles in round to nearest with `kDoubleDoubleUnit`. Floats have a model
/// of their own, below.
///
/// Input: m_w bounds the magnitudes of `to_center`'s computed components and of r, m_e those of `edge`, m_N those of
/// the normal. Components of `to_center` and `edge` are known to unit m_w and unit m_e, those of the normal to kNormal
/// unit m_N, r exactly. Magnitudes may exceed their maximum by a factor of 1 + 2^-50: so the maximum of double-doubles
/// also serves for their high parts, and 2 m_u m_v, computed in any rounding direction, serves as m_N. Every maximum is
/// at most `kLargest`, m_N at most 2 kLargest^2.
///
/// Then the computed value of a sign of signs.h differs from the exact one by less than
///   k... unit (product of maxima) + kTiny,
/// which covers the rounding of the bound itself, in any order of its factors and in any rounding direction, and the
/// comparison of a double-double's high part with it.
namespace touchstone::filtered::detail::bounds {

inline constexpr double kUnit = 0x1p-52;
inline constexpr double kDoubleDoubleUnit = 0x1p-103;
inline constexpr double kTiny = 0x1p-600;
inline constexpr double kLargest = 0x1p64;
/// If every maximum is at least this and m_N is 2 m_u m_v, kTiny need not be added to a bound with `kUnit`.
inline constexpr double kSmallest = 0x1p-90;

inline constexpr double kVertex = 18.0625;      ///< m_w^2
inline constexpr double kAlong = 14.0625;       ///< m_w m_e
inline constexpr double kBeyond = 34.0625;      ///< m_e max(m_w, m_e)
inline constexpr double kLine = 160.0625;       ///< m_w^2 m_e^2
inline constexpr double kNormal = 4.0625;       ///< m_N = 2 m_u m_v, for each component of the normal of edges u, v
inline constexpr double kFront = 23.25;         ///< m_N m_w
inline constexpr double kPlane = 195.5625;      ///< m_N^2 m_w^2
inline constexpr double kSide = 64.4375;        ///< m_N m_e m_w
inline constexpr double kAbove = 82.8125;       ///< m_N^2 m_w
inline constexpr double kLineAhead = 163.0625;  ///< m_w^2 m_e^2; m_w also bounds c'' - a, known to unit m_w
/// For a motion, whose velocity's components are at most m_d in magnitude and known to unit m_d.
inline constexpr double kApart = 46.0625;    ///< m_w m_e m_d
inline constexpr double kLines = 776.0625;   ///< m_w^2 m_e^2 m_d^2
inline constexpr double kOnEdge = 128.0625;  ///< m_w m_e m_d^2
inline constexpr double kOnWay = 128.0625;   ///< m_w m_e^2 m_d

/// The isometric frame (edge_frame.h). W bounds the components of c - origin as computed, each known to unit W; those
/// of an axis are at most 1 and known to unit. Then a frame coordinate is known to kCoordinate unit W + kTiny. W is at
/// most kLargest, and so is S.
inline constexpr double kCoordinate = 14.0625;
/// Edges are stored as frame.h computes them: in each coordinate, their ends are known to kFramePoint unit and
/// their unit directions to kFrameDirection unit; their lengths are known to kFrameLength unit.
inline constexpr double kFramePoint = 1.9375;
inline constexpr double kFrameDirection = 10.6875;
inline constexpr double kFrameLength = 8.75;
/// S >= 1 bounds the foot's computed coordinates, W, and the starts of edges. Then `along` and `across` are known to
/// kEdgeFrame unit S each.
inline constexpr double kEdgeFrame = 86.8125;

/// Heights and distances computed from these, with S = 2 max(W, 1). Vertices and the plane are at most kExtent from the
/// origin, and no edge is longer. The height of the plane is known to unit. Then the height above the plane is known to
/// kHeight unit S, which includes one rounded sum of the height and this error. The root of the computed square of the
/// foot's distance from an edge is known to kDistance unit S. In frames from Frame::kSubnormal up this also covers
/// subnormal numbers that are flushed to zero.
inline constexpr double kExtent = 1.5;
inline constexpr double kHeight = 12.75;
inline constexpr double kDistance = 102.25;
/// In the caller's unit the height above the plane is known to kGivenHeight times the sum of the largest number of the
/// ball, the largest coordinate of the origin and the unit of the frame, computed in any rounding direction.
inline constexpr double kGivenHeight = 18.0625 * kUnit;
/// If a computed distance exceeds kNear kDistance unit S, the foot is not on the edge, and it lies on the computed side
/// of the edge's line. From the square of that distance on: if an edge in a box has a computed squared distance q from
/// the foot, the box has at most kBoxReach q; and it is certain on which side of the foot a box beyond that lies.
inline constexpr double kNear = 3.5;
inline constexpr double kBoxReach = 1.21875;
/// Half sizes of boxes contain the rounded points and this much more, for their own rounding to nearest.
inline constexpr double kBoxRounding = 0x1p-47;
/// Lengths and squares, in any rounding direction, times these are larger or smaller than they would be without
/// rounding.
inline constexpr double kWide = 1 + 0x1p-48;
inline constexpr double kNarrow = 1 - 0x1p-48;

/// Triangles in lanes (triangle_groups.h), in floats. Every operation on them follows the model with kFloatUnit, except
/// that underflow costs at most kFloatTiny. All lengths are in the group's units. S is the largest of 1, of the radius,
/// and of the centre's components as seen from the origin, each known to kLaneCentre kFloatUnit S; a vertex seen from
/// it is known to kLaneVertex kFloatUnit 2 S. Edges of stored triangles are exact.
inline constexpr double kFloatUnit = 0x1p-23;
inline constexpr double kFloatTiny = 0x1p-125;
inline constexpr double kLaneCentre = 1.0625;
inline constexpr double kLaneVertex = 1.5625;
/// The point with given weights is known to kLanePoint kFloatUnit 2 S in each coordinate. The product of a given
/// direction, whose components are at most m, with a vertex or an edge is known to kLaneProduct kFloatUnit m 2 S.
inline constexpr double kLanePoint = 8.625;
inline constexpr double kLaneProduct = 12.75;
/// Added to the square of a length in steps, so that the length is known also where its square underflows.
inline constexpr double kLaneTiny = 0x1p-40;
/// A point of a stored triangle is at most kLaneStored from a point of the given one, and the other way round. The
/// distance of a point from the centre, and the least product of its direction with a vertex, divided by that distance,
/// are known to kLaneDistance kFloatUnit S. This includes the rounding of the limits that are compared.
inline constexpr double kLaneStored = 0x1.bb7p-16;
inline constexpr double kLaneDistance = 61;

/// The errors of `dot` and `cross` of double-doubles (numbers/double_double.h), in units of kDoubleDoubleUnit m_a m_b,
/// where m_a and m_b bound the components of the vectors. They are the same as for the products and sums of vector3.h,
/// each rounded separately. Underflow adds at most 2^-1069, less than in one operation of the model: each of at most 18
/// products of words, four of them in an error-free product, loses at most 2^-1075, and sums lose nothing.
inline constexpr double kDot = 8;
inline constexpr double kCross = 4;
/// The constants of `vertex`, `line` and `plane` times this hold over exact vectors without a step that normalises
/// (numbers/lane_vector.h).
inline constexpr double kUnnormalised = 2;
/// The relative error of quotients, reciprocals and roots of double-doubles, in units of kDoubleDoubleUnit.
inline constexpr double kQuotient = 2;

/// Double-doubles (prepared.h, exact_edges.h), lengths in the frame's unit. A vertex's lift is known to kLift, a slope
/// of the plane to kSlope kDoubleDoubleUnit; the lifted component of an edge to kLiftedEdge times the largest component
/// of the edge as it was given.
inline constexpr double kLift = 0x1p-99;
inline constexpr double kSlope = 4.0625;
inline constexpr double kLiftedEdge = 0x1p-99;
/// With maxima this many times as large (that of vertices is 1) lifted numbers are known to kDoubleDoubleUnit.
inline constexpr double kLiftedMaximum = 32;
/// Signs require that a component of a polygon's normal is known to kNormal units of m_N. Closest points require more:
/// the step along the normal is proportional to N_k in coordinate k, so N_k must be known to kDoubleDoubleUnit |N_k|
/// plus kNormalUnderflow.
inline constexpr double kNormalUnderflow = 0x1p-1074;
/// 1 / N.N is known to kPerSquare kDoubleDoubleUnit of itself.
inline constexpr double kPerSquare = 12.0625;
/// Closest points and distances (closest_point.h), with direction D and maxima m_w, m_D. The step D.to_center D_k / D.D
/// is known to kClosest m_w m_D |D_k| / D.D; plus kClosest m_e for lifted edges, between whose ends the foot lies; plus
/// kClosest m_w m_N / |N| for computed normals. A distance from an edge or a plane is known to kClosest times the sum
/// of m_w m_D / |D| and the distance; one from a vertex to kClosest times the sum of the distance and, if the vertex is
/// lifted, m_w. Computed values may replace exact ones in these bounds.
inline constexpr double kClosest = 0x1p-94;

/// Numbers that carry their error (numbers/bounded.h): the errors of `dot` and `cross` of exact vectors in lanes, in
/// units of kUnit m_a m_b.
inline constexpr double kRoundedDot = 8.0625;
inline constexpr double kRoundedCross = 4.0625;
/// Covers the roundings of 2^12 errors that are computed from each other, each with at most eight operations.
inline constexpr double kWideError = 1 + 0x1p-36;
/// The largest coordinate and radius of a motion, in the unit in which it is answered.
inline constexpr double kLongestMotion = 0x1p30;

}  // namespace touchstone::filtered::detail::bounds
