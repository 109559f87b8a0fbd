// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "experiments/cell/first_contact/arc.h"
#include "geometry/contact/answer.h"
#include "robust/scene/scene.h"

namespace touchstone::kinematics {

/// The first angle of a move at which the ball touches a face.
struct FirstContact {
  enum class Kind {
    AtStart,      ///< it touches before it moves: low = high = 0
    Transversal,  ///< the distance to the feature passes through the radius
    Grazing,      ///< the distance to the feature only comes down to the radius there: a tangency, exactly
  };
  double low, high;  ///< degrees; the exact angle lies between them, both included
  Kind kind;
  std::size_t face;  ///< triangles first, then polygons, numbered together from 0
  Feature feature;   ///< the nearest one of that face, at that angle
};

[[nodiscard]] std::string_view word(FirstContact::Kind kind);

/// Where a ball whose centre goes along the arc first touches one of the faces; nothing where it touches none on the
/// whole move, its end included. At the start its `feature` is the one that is nearest there.
///
/// Ball and faces are closed, centre and faces those exact sets of points that their doubles mean (arc.h, and
/// polygon.h on lifted ones).
///
/// Guarantees
///  (1) at no angle below `low` does the ball touch any face; nothing is returned only where it touches none;
///  (2) it does touch at an angle from `low` to `high`, and they are at most 1e-12 degrees apart, grazing or not;
///  (3) a contact whose angle 200 bits cannot tell from the end of the move counts as on the move;
///  (4) among contacts whose enclosures overlap the lowest face is named; within a face they are compared exactly, and
///      among equal ones the face comes before its edges, they before its vertices, then the lowest index.
///
/// How: with the half angle's tangent as a parameter the exact centre is a quotient of polynomials with integer
/// coefficients, so the ball touches a plane, the line of an edge or a vertex at the real roots of polynomials of
/// degree 4, 4 and 2. Those are isolated by Sturm's theorem, and that the touched point belongs to the face is the
/// sign of a polynomial at such a root: all in integers, so that a tangency is decided like anything else. Intervals
/// (libmpfi has the sines) could not tell a grazing contact from a near miss. The angle itself is enclosed by MPFR with
/// directed rounding.
///
/// Faces that the boxes of pieces of the arc do not meet cost some 10 ns; one that is met some 0.3 ms, more with many
/// edges near the arc. Throws std::invalid_argument for an arc as require_valid does, Rejected for a radius that is
/// negative or not finite. Requires faces that exact::validate accepts.
[[nodiscard]] std::optional<FirstContact> first_contact(const Arc& arc, double radius, const scene::Faces& faces);

}  // namespace touchstone::kinematics
