// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "experiments/thesis/cell/first_contact/arc.h"
#include "geometry/contact/answer.h"
#include "robust/scene/scene.h"

namespace touchstone::kinematics {

/// The first angle of a move at which the ball touches a face.
struct FirstContact {
  enum class Kind {
    AtStart,      ///< it touches before it moves: low = high = 0
    Transversal,  ///< the distance to the feature passes through the radius
    Grazing,      ///< the distance to the feature only reaches the radius there: an exact tangency
  };
  double low, high;  ///< degrees; the exact angle lies between them, both included
  Kind kind;
  std::size_t face;  ///< triangles first, then polygons, numbered together from 0
  Feature feature;   ///< the nearest one of that face, at that angle
};

[[nodiscard]] std::string_view to_string(FirstContact::Kind kind);

/// Returns where a ball whose centre moves along the arc first touches one of the faces, or nothing if it touches none
/// on the whole move, its end included. For a contact at the start, `feature` is the nearest one there.
///
/// Ball and faces are closed; centre and faces are the exact point sets that their doubles define (arc.h, and polygon.h
/// for lifted polygons).
///
/// Guarantees
///  (1) the ball touches no face at any angle below `low`; nothing is returned only if it touches none;
///  (2) it touches at an angle from `low` to `high`, which are at most 1e-12 degrees apart, grazing or not;
///  (3) a contact whose angle cannot be distinguished from the end of the move with 200 bits counts as on the move;
///  (4) among contacts whose enclosures overlap, the lowest face is reported; within a face contacts are compared
///      exactly, and for ties the face precedes its edges, edges precede vertices, then the lowest index wins.
///
/// Method: with the half angle's tangent as the parameter, the exact centre is a quotient of polynomials with integer
/// coefficients. So the ball touches a plane, the line of an edge or a vertex at the real roots of polynomials of
/// degree 4, 4 and 2. These are isolated by Sturm's theorem. Whether the touched point belongs to the face is the sign
/// of a polynomial at such a root. All of this is computed in integers, so a tangency needs no special treatment.
/// Interval arithmetic (libmpfi has sines) could not distinguish a grazing contact from a near miss. MPFR encloses the
/// angle itself with directed rounding.
///
/// A face costs about 10 ns if no box of a piece of the arc meets it, otherwise about 0.3 ms, more with many edges near
/// the arc. Throws std::invalid_argument for an invalid arc as require_valid does, and Rejected for a radius that is
/// negative or not finite. Requires faces that exact::validate accepts.
[[nodiscard]] std::optional<FirstContact> first_contact(const Arc& arc, double radius, const scene::Faces& faces);

/// The first of the stops 0, 1, 2, ... of a move at which the ball touches a face.
struct SteppedContact {
  std::uint64_t stop;
  double degrees;    ///< stop times step
  std::size_t face;  ///< the lowest, numbered as in FirstContact
};

/// Finds contact as the thesis does: tests the ball after every `step` degrees, not between. At each stop the centre is
/// rounded as by point_at; the contact test of that ball is exact (`filtered`). There are no stops beyond the end of
/// the move. Throws as first_contact does, and std::invalid_argument for a step that is not finite and positive.
[[nodiscard]] std::optional<SteppedContact> stepped_contact(const Arc& arc, double radius, double step,
                                                            const scene::Faces& faces);

}  // namespace touchstone::kinematics
