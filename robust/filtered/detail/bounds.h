// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The constants that the filters rest on, each proved in robust/proofs by the test run.
///
/// Model: every operation returns its exact result times (1 + d), |d| <= unit, plus at most 2^-1021 in magnitude
/// (underflow, flushed to zero or not). It holds for doubles in every rounding direction with `kUnit`, for fused and
/// unfused products alike, and for double-doubles in round to nearest with `kDoubleDoubleUnit`.
///
/// Input: m_w bounds the magnitudes of `to_center`'s computed components and of r, m_e those of `edge`, m_N those of
/// the normal. Components of `to_center` and `edge` are known to unit m_w and unit m_e, those of the normal to kNormal
/// unit m_N, r exactly. What a maximum bounds may exceed it by a factor of 1 + 2^-50: so the high parts of
/// double-doubles have the maximum of the sums, and 2 m_u m_v serves as m_N as computed, in any rounding direction.
/// Every maximum is at most `kLargest`, m_N at most 2 kLargest^2.
///
/// Then the computed value of a sign of signs.h differs from the exact one by less than
///   k... unit (product of maxima) + kTiny,
/// the rounding of that bound itself included, in any order of its factors and in any rounding direction, and also the
/// comparison of a double-double's high part with it.
namespace touchstone::filtered::bounds {

inline constexpr double kUnit = 0x1p-52;
inline constexpr double kDoubleDoubleUnit = 0x1p-103;
inline constexpr double kTiny = 0x1p-600;
inline constexpr double kLargest = 0x1p64;
/// Where every maximum is at least this and m_N is 2 m_u m_v, kTiny need not be added to a bound with `kUnit`.
inline constexpr double kSmallest = 0x1p-90;

inline constexpr double kVertex = 18.0625;  ///< m_w^2
inline constexpr double kAlong = 14.0625;   ///< m_w m_e
inline constexpr double kBeyond = 34.0625;  ///< m_e max(m_w, m_e)
inline constexpr double kLine = 160.0625;   ///< m_w^2 m_e^2
inline constexpr double kNormal = 4.0625;   ///< m_N = 2 m_u m_v, for each component of the normal of edges u, v
inline constexpr double kFront = 23.25;     ///< m_N m_w
inline constexpr double kPlane = 195.5625;  ///< m_N^2 m_w^2
inline constexpr double kSide = 64.4375;    ///< m_N m_e m_w
inline constexpr double kAbove = 82.8125;   ///< m_N^2 m_w

/// The isometric frame (edge_frame.h). W bounds the components of c - origin as computed, each known to unit W; those
/// of an axis are at most 1 and known to unit. Then a frame coordinate is known to kCoordinate unit W + kTiny. W is at
/// most kLargest, and so is S.
inline constexpr double kCoordinate = 14.0625;
/// S >= 1 bounds the foot's computed coordinates and W; starts of edges are at most S in magnitude and, like unit
/// directions, known to unit in each coordinate. Then `along` and `across` are known to kEdgeFrame unit S each.
inline constexpr double kEdgeFrame = 46.1875;

/// What is made of them, with S = 2 max(W, 1). Vertices and the plane are at most kExtent from the origin, no edge is
/// longer, all known to unit. Then the height above the plane is known to kHeight unit S, one rounded sum of the height
/// and this error included, and the root of the computed square of the foot's distance from an edge to kDistance unit
/// S. That also covers what a frame from Frame::kSubnormal up makes of subnormal numbers that are flushed to zero.
inline constexpr double kExtent = 1.5;
inline constexpr double kHeight = 12.75;
inline constexpr double kDistance = 74.5;
/// Distances computed beyond kNear kDistance unit S are from feet that are off the edge, and on the side of its line
/// that is computed. From the square of that on: a box with an edge within some computed square of the foot has a
/// computed square of at most kBoxReach times as much, and of a box beyond that it is certain on which side it lies.
inline constexpr double kNear = 3;
inline constexpr double kBoxReach = 1.25;
/// Halves of boxes hold the points as rounded, and this much more for their own rounding, to nearest.
inline constexpr double kBoxRounding = 0x1p-47;
/// More than 14 operations may lose or gain in any direction, relatively.
inline constexpr double kWide = 1 + 0x1p-48;
inline constexpr double kNarrow = 1 - 0x1p-48;

/// `dot` and `cross` of double-doubles (numbers/double_double.h) are off by at most so many kDoubleDoubleUnit m_a m_b,
/// where m_a and m_b bound the components of the vectors: as many as the products and sums of vector3.h may be off,
/// each rounded for itself. Underflow adds at most 2^-1069, less than in one operation of the model: each of at most 18
/// products of words, four of them in an error-free product, loses at most 2^-1075, and sums lose nothing.
inline constexpr double kDot = 8;
inline constexpr double kCross = 4;
/// Quotients and roots of double-doubles are off by at most so many kDoubleDoubleUnit of themselves.
inline constexpr double kQuotient = 2;

/// Double-doubles (prepared.h, exact_edges.h), lengths in the frame's unit. A vertex's lift is known to kLift; the
/// lifted component of an edge to kLiftedEdge times the largest component of the edge as it was given.
inline constexpr double kLift = 0x1p-99;
inline constexpr double kLiftedEdge = 0x1p-98;
/// Maxima so many times as large, of vertices that of 1, know them to kDoubleDoubleUnit.
inline constexpr double kLiftedMaximum = 32;
/// Signs ask that a component of a polygon's normal is known to kNormal units of m_N. Closest points ask for more: a
/// step along the normal is as long in coordinate k as N_k is large, so N_k must be known to kDoubleDoubleUnit |N_k|,
/// and but for that to kNormalUnderflow.
inline constexpr double kNormalUnderflow = 0x1p-1074;
/// Closest points and distances (closest_point.h), with direction D and maxima m_w, m_D. The step D.to_center D_k / D.D
/// is known to kClosest m_w m_D |D_k| / D.D; for lifted edges, between whose ends the foot lies, and kClosest m_e more;
/// for computed normals and kClosest m_w m_N / |N| more. A distance from an edge or a plane is known to kClosest times
/// m_w m_D / |D| and itself, one from a vertex to kClosest times itself and, where it is lifted, m_w. Computed values
/// stand for exact ones in these bounds.
inline constexpr double kClosest = 0x1p-94;

}  // namespace touchstone::filtered::bounds
