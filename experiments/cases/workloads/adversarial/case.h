// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::workloads::adversarial {

/// The property that makes a case hard. All but Outline are triangles.
enum class Family {
  General,    ///< coordinates with all their bits; the radius within some doubles of the distance
  Lattice,    ///< integers of few bits throughout: ties of every kind
  Tangent,    ///< exactly tangent: Pythagorean offsets in integer frames, and coordinate planes with all bits
  Needle,     ///< vertices nearly on a line, or nearly equal
  FarAway,    ///< up to 2^50 sizes from the origin, so that few bits are left for the shape
  Foot,       ///< the foot within some doubles of an edge or vertex; ample radius, or at the distance
  Point,      ///< radius zero, or centres on the triangle, or within some doubles of that
  Close,      ///< centres within 2^-60 to the least double of a vertex, edge or face that lies at the origin
  Grazing,    ///< radii up to 2^60 sizes, at the distance
  Exponents,  ///< coordinates of wildly different magnitudes, from the least double to the largest
  Scaled,     ///< one of the above times a power of two, down to the least double and up to the largest
  Anywhere,   ///< nothing special
  Outline,    ///< polygons of all families of workloads: lattice or rotated, with holes, off their planes, scaled
};

[[nodiscard]] std::string_view to_string(Family family);
[[nodiscard]] const std::vector<Family>& all_families();

/// A ball and a polygon that `exact::validate` accepts.
struct Case {
  Family family;
  Ball ball;
  Polygon polygon;

  /// Returns the polygon as a triangle, if it is one.
  [[nodiscard]] std::optional<Triangle> triangle() const;
};

/// Returns the name of a case, such as "soak-s7-i12".
[[nodiscard]] std::string name_of_case(std::uint64_t seed, std::uint64_t index);

/// Draws case number `index`: a function of (seed, index) alone. Nine of ten are triangles, evenly from all families.
/// Requires rounding to nearest. Cost: about 4 us for a triangle, 50 us for an outline.
[[nodiscard]] Case draw_case(std::uint64_t seed, std::uint64_t index);

/// Draws case number `index` with numbers below 2^-970 and above 2^970 in any argument (outlines.h): a function of
/// (seed, index) alone. Returns nothing if the numbers drawn are not a case.
[[nodiscard]] std::optional<Case> draw_extreme_case(std::uint64_t seed, std::uint64_t index);

/// Draws how the ball of case `index` moves: a function of (seed, index) alone, which `find_fault` accepts.
///
/// The ball's place is at the start, in the middle or at the end of its way. The way is parallel to an edge or to an
/// axis, leads towards a vertex or past it at a right angle, through the face, in any direction, far away, or nowhere.
/// In a quarter of the draws the radius is the one that just grazes, up to a double, instead of that at the place.
[[nodiscard]] Motion draw_motion(const Case& drawn, std::uint64_t seed, std::uint64_t index);

/// Draws the same for an extreme case: a coordinate of an end may be such a number, too.
[[nodiscard]] Motion draw_extreme_motion(const Case& drawn, std::uint64_t seed, std::uint64_t index);

}  // namespace touchstone::workloads::adversarial
