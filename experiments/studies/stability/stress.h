// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/numbers/vector3.h"

namespace touchstone::stability {

/// An axis of stress: one property that gets worse level by level, while everything else stays as good as possible.
enum class Axis {
  Aspect,            ///< outlines squeezed along one direction: length over width
  Parallel,          ///< the angle between two neighbouring edges: of a crack, or of a bend in a side
  Duplicate,         ///< the distance of two vertices, in sizes: a cut corner, or the mouth of a pocket
  CollinearExact,    ///< the number of additional vertices on one straight side, on the integer lattice
  CollinearRounded,  ///< the same, each vertex rounded to doubles
  Origin,            ///< the distance from the origin, in sizes
  Small,             ///< the exponent of the polygon's largest coordinate, down to the least doubles
  Large,             ///< the same, up to the largest
  Mixed,             ///< the ratio between the coordinate axes, in binary orders of magnitude
  OffPlane,          ///< one vertex moved off the plane of the others, in ulps of the largest coordinate
  Vertices,          ///< the number of vertices
  ChainInput,   ///< the length of a chain of rotations of all points in doubles, compared with the exact answer on its
                ///< result
  ChainMotion,  ///< the same chain, compared with the exact answer for the intended motion
  PoseInput,    ///< the length of a chain of products of pose matrices in doubles, compared as ChainInput
  PoseMotion,   ///< the same chain of poses, compared as ChainMotion
  Rounding,     ///< the rounding direction while a method prepares and answers
  Flush,        ///< subnormal results (FTZ) and operands (DAZ) taken as zero, in scenes that have them
};

/// A step of an axis.
struct Level {
  std::string name;      ///< as printed in tables
  double value;          ///< the value of the property; for Rounding and Flush, the index in the list
  std::uint64_t one_in;  ///< one of this many samples is drawn at this level, because more would take too long
};

[[nodiscard]] std::string_view to_string(Axis axis);
[[nodiscard]] const std::vector<Axis>& all_axes();
/// Returns the levels, from harmless to worst.
[[nodiscard]] const std::vector<Level>& levels(Axis axis);
/// Returns whether a sample is drawn at the level: one of each Level::one_in. Its position in the group changes from
/// group to group, because scenes alternate with the sample's number.
[[nodiscard]] bool is_drawn(Axis axis, std::size_t level, std::uint64_t sample);
/// Returns whether the answer is compared with that for the intended motion, instead of that for the given doubles.
[[nodiscard]] bool against_motion(Axis axis);

/// A rational number of GMP for use in generic expressions: gmpxx's own operators return expression templates, which
/// would refer to destroyed operands.
struct Rational {
  mpq_class value;

  friend Rational operator+(const Rational& a, const Rational& b) { return {mpq_class(a.value + b.value)}; }
  friend Rational operator-(const Rational& a, const Rational& b) { return {mpq_class(a.value - b.value)}; }
  friend Rational operator*(const Rational& a, const Rational& b) { return {mpq_class(a.value * b.value)}; }
  friend Rational operator/(const Rational& a, const Rational& b) { return {mpq_class(a.value / b.value)}; }
};

using RationalVector = filtered::detail::Vector3<Rational>;

inline Rational exactly(double x) { return {mpq_class(x)}; }
inline RationalVector exactly(const Eigen::Vector3d& v) { return {exactly(v.x()), exactly(v.y()), exactly(v.z())}; }
inline RationalVector operator+(const RationalVector& a, const RationalVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline RationalVector operator-(const RationalVector& a, const RationalVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// Converts to a number with 512 bits and any exponent.
inline mpf_class real(const Rational& number) { return {number.value, 512}; }

// The actual stress of a polygon of doubles, computed in rationals and finally rounded to a relative 1e-15 or so. It
// verifies that a scene has the stress of its level.

/// Returns the distance of the two farthest vertices divided by the width perpendicular to their connection, in the
/// supporting plane of the first loop: for a triangle, its longest side over the height on it; for a square, 1.
/// Requires a normal. Cost: quadratic.
[[nodiscard]] double aspect_ratio(const Polygon& polygon);

/// Returns the sine of the angle between the lines of the two edges that meet at a vertex.
[[nodiscard]] double sine_at(const Polygon& polygon, std::size_t vertex);

/// Returns the distance of two vertices divided by the longest side of the polygon's box.
[[nodiscard]] double relative_distance(const Polygon& polygon, std::size_t first, std::size_t second);

/// Returns the distance of vertex 0 from the origin divided by the longest side of the polygon's box.
[[nodiscard]] double relative_origin_distance(const Polygon& polygon);

/// Returns the exponent of the largest coordinate.
[[nodiscard]] int largest_exponent(const Polygon& polygon);

}  // namespace touchstone::stability
